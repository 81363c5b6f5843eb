// A Web Worker that runs RayCaster. A message is an exported method of Program.cs and its arguments; the answers are those of a server.
// It starts at "Begin"; the calls before that wait.

async function start() {
  if (!globalThis.WebAssembly) throw new Error("it runs no WebAssembly, which a phone's Lockdown Mode turns off");
  const { dotnet } = await import("./_framework/dotnet.js");
  const { getAssemblyExports, getConfig, setModuleImports } = await dotnet.create();
  setModuleImports("worker", {
    post: message => postMessage(message),
    postFrame: (header, pixels) => {
      const frame = new Uint8Array(header.byteLength + pixels.byteLength);
      header.copyTo(frame);
      pixels.copyTo(frame.subarray(header.byteLength));
      postMessage(frame.buffer, [frame.buffer]);
    },
  });
  return (await getAssemblyExports(getConfig().mainAssemblyName)).RayCaster.Web.Program;
}

let begin = null;
const program = new Promise(resolve => { begin = resolve; }).then(start);
addEventListener("message", async ({ data: [method, ...values] }) => method === "Begin" ? begin() : (await program)[method](...values));
addEventListener("unhandledrejection", event => setTimeout(() => { throw event.reason; })); // so that the page hears of it as an error
