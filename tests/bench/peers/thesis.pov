// The thesis' scene with key a, for POV-Ray (left-handed: z is turned round).
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 0.8 }
// angle is horizontal: 2 atan(tan(25 / 2) * 640 / 480)
camera { perspective location <0, 0, 0> look_at <0, 0, 1> angle 32.9246 right x * 4 / 3 }
#declare Matte = finish { ambient 0 emission 0 diffuse 1 }
sphere { <0, 0, 20>, 4 pigment { rgb 1 } finish { Matte } }
sphere { <0, -10004, 20>, 10000 pigment { rgb 0.2 } finish { Matte } }
light_source { <-20, 20, 10>, rgb 1 }
sphere { <-20, 20, 10>, 3 pigment { rgb 1 } finish { ambient 0 emission 1 diffuse 0 } no_shadow }
