// A team in Python: an interpreter in this worker, with the messages of the interface.
import messages from '../python/cls_messages.py?text';
import starter from '../python/cls_team.py?text';

const kHome = '/team';
const kNowhere = 'https://runtime.invalid/'; // Pyodide wants an address for its files, which are here already

/** One line: the error, and the last place in the team's code. */
function teamError(error) {
  const text = String(error?.message ?? error).trim();
  const place = [...text.matchAll(/File "\/team\/(\w+\.py)", line (\d+)/g)].filter(([, file]) => !file.startsWith('cls_')).at(-1);
  const what = text.split('\n').at(-1);
  const made = new Error(place ? `${what} (${place[1]}:${place[2]})` : what);
  made.name = ''; // the text has that of Python
  made.stack = '';
  return made;
}

/** Pyodide from its files, whatever it asks the network for: that is refused here. @param {Record<string, Uint8Array>} runtime */
async function interpreter(runtime) {
  const program = (name) => import(URL.createObjectURL(new Blob([runtime[name]], { type: 'text/javascript' })));
  const { loadPyodide } = await program('pyodide.mjs');
  const { default: createPyodideModule } = await program('pyodide.asm.mjs');
  const { fetch } = self;
  self.fetch = async (address) => new Response(runtime[String(address).replace(/^.*\//, '')], { headers: { 'Content-Type': 'application/wasm' } });
  try {
    const lockFileContents = new TextDecoder().decode(runtime['pyodide-lock.json']);
    return await loadPyodide({ indexURL: kNowhere, lockFileContents, createPyodideModule });
  } finally {
    self.fetch = fetch;
  }
}

/**
 * Loads a team; rejects with an error of one line.
 * @param {Record<string, string>} files @param {Record<string, Uint8Array>} runtime files of Pyodide @param {object} schema of the messages
 * @param {() => void} onReady the interpreter is there, and the team's code begins
 * @returns {Promise<{answer: (rpc: string, state: Uint8Array) => Uint8Array | undefined}>}
 */
export async function loadPythonTeam(files, runtime, schema, onReady) {
  const python = await interpreter(runtime);
  python.setStdout({ batched: (text) => console.log(text) });
  python.setStderr({ batched: (text) => console.error(text) });
  python.FS.mkdirTree(kHome);
  for (const [name, text] of Object.entries({ ...files, 'cls_messages.py': messages, 'cls_team.py': starter })) python.FS.writeFile(`${kHome}/${name}`, text);
  onReady();
  try {
    python.runPython(`import sys\nsys.path.insert(0, '${kHome}')\nimport cls_team`);
    const team = python.globals.get('cls_team');
    team.load(JSON.stringify(schema));
    const decide = team.answer;
    return { answer: (rpc, state) => replyOf(decide, rpc, state) };
  } catch (error) {
    throw teamError(error);
  }
}

function replyOf(decide, rpc, state) {
  let reply;
  try {
    reply = decide(rpc, state);
  } catch (error) {
    throw teamError(error);
  }
  if (reply === undefined || reply === null) return undefined;
  const buffer = reply.getBuffer();
  const bytes = buffer.data.slice();
  buffer.release();
  reply.destroy();
  return bytes;
}
