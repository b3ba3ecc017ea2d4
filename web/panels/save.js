// Files for whoever looks at the page.

const TAKEN_MS = 10_000; // by then the browser has begun to write the file

/** Saves a blob as a file called `name`. */
export function save(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), TAKEN_MS);
}
