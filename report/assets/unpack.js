// Texts that the page holds deflated: libraries and trajectories.

function clastBytes(base64) {
  const raw = atob(base64), bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) bytes[i] = raw.charCodeAt(i);
  return bytes;
}

async function clastUnpacked(id) {
  if (typeof DecompressionStream === 'undefined') {
    throw new Error('This browser can\'t unpack charts and 3-D views: it is older than 2023.');
  }
  const packed = new Blob([clastBytes(document.getElementById(id).textContent)]);
  return new Response(packed.stream().pipeThrough(new DecompressionStream('deflate'))).text();
}

// Runs a packed script, once.
const clastScripts = {};
function clastRun(id) {
  const run = (code) => {
    const script = document.createElement('script');
    script.textContent = code;
    document.head.append(script);
  };
  return clastScripts[id] = clastScripts[id] || clastUnpacked(id).then(run);
}
