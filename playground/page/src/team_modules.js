// The modules of a team as modules of this worker.

/**
 * Loads a team from its modules, each after those that it imports.
 * @param {{name: string, pieces: (string | {module: string})[]}[]} modules the last one decides; the pieces of a text
 *   are the text itself and, between them, the modules that it imports
 */
export async function loadTeam(modules) {
  const addresses = new Map();
  for (const { name, pieces } of modules) {
    const text = pieces.map((piece) => (typeof piece === 'string' ? piece : addresses.get(piece.module))).join('');
    // Names the module in stacks, as lineOf() reads them.
    const blob = new Blob([text, `\n//# sourceURL=${name}\n`], { type: 'text/javascript' });
    addresses.set(name, URL.createObjectURL(blob));
  }
  const { name } = modules.at(-1);
  const team = await importModule(addresses.get(name), name);
  if (typeof team.decide !== 'function') throw new TypeError(`${name} exports no function decide`);
  return team;
}

async function importModule(address, name) {
  try {
    return await import(address);
  } catch (error) {
    const place = /([\w.-]+\.m?js:\d+)/.exec(error?.stack ?? '')?.[1];
    throw new Error(`${error} (${place ?? name})`);
  }
}
