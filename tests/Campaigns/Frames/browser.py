#!/usr/bin/env python3
"""Draws some frames, joins them into an animated PNG, and has headless Chromium decode it: every frame of the animation must be, pixel for
pixel, the frame's own file, and must be shown for its time. Needs chromium and a built raycaster (RAYCASTER, or
what "dotnet build src/RayCaster.Cli" leaves).
Usage: browser.py [frames] [frames per second]"""
import datetime, functools, http.server, os, pathlib, queue, subprocess, sys, tempfile, threading

root = pathlib.Path(__file__).resolve().parents[3]
raycaster = os.environ.get("RAYCASTER", str(root / "src/RayCaster.Cli/bin/Release/net10.0/raycaster"))
frames, fps = int(sys.argv[1]) if len(sys.argv) > 1 else 12, int(sys.argv[2]) if len(sys.argv) > 2 else 20

PAGE = """<!doctype html><script>
async function decode(url) {
  const decoder = new ImageDecoder({ type: "image/png", data: (await fetch(url)).body });
  await decoder.completed;
  const track = decoder.tracks.selectedTrack, pictures = [];
  for (let i = 0; i < track.frameCount; i++) {
    const { image } = await decoder.decode({ frameIndex: i });
    const canvas = new OffscreenCanvas(image.displayWidth, image.displayHeight), context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    pictures.push({ data: context.getImageData(0, 0, canvas.width, canvas.height).data, duration: image.duration });
  }
  return { pictures, animated: track.animated, repetitions: track.repetitionCount };
}
(async () => {
  const film = await decode("film.png");
  const lines = [`animated ${film.animated} frames ${film.pictures.length} for ever ${film.repetitions === Infinity}`];
  for (let i = 0; i < film.pictures.length; i++) {
    const own = (await decode(`film/mesh-${String(i).padStart(4, "0")}.png`)).pictures[0].data, mine = film.pictures[i].data;
    let differing = mine.length === own.length ? 0 : -1;
    for (let k = 0; k < own.length && differing >= 0; k++) if (own[k] !== mine[k]) differing++;
    lines.push(`frame ${i} bytes ${own.length} differing ${differing} shown ${film.pictures[i].duration} us`);
  }
  return lines.join("\\n");
})().catch(e => "error " + e).then(text => fetch("result", { method: "POST", body: text + "\\ndone" }));
</script>"""

class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass

    def do_POST(self):
        results.put(self.rfile.read(int(self.headers["Content-Length"])).decode())
        self.send_response(204)
        self.end_headers()

results = queue.Queue()

with tempfile.TemporaryDirectory() as folder:
    run = functools.partial(subprocess.run, cwd=folder, check=True)
    os.mkdir(f"{folder}/film")
    run([raycaster, "orbit", str(root / "scenes/mesh.json"), "-q", "--frames", str(frames), "-s", "160x120", "-o", "film"])
    run([raycaster, "animate", "film", "-q", "-o", "film.png", "--fps", str(fps)])
    pathlib.Path(folder, "index.html").write_text(PAGE)
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    browser = subprocess.Popen(["chromium", "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/profile",
                                "--remote-debugging-port=0", f"http://localhost:{server.server_address[1]}/index.html"],
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        out = results.get(timeout=90)
    except queue.Empty:
        sys.exit("FAILED: the browser does not answer")
    finally:
        browser.terminate()
        browser.wait()
        server.shutdown()
    version = subprocess.run(["chromium", "--version"], capture_output=True, text=True).stdout.strip()

lines = out.split("\n")
expected = [f"animated true frames {frames} for ever true"]
expected += [f"frame {i} bytes {160 * 120 * 4} differing 0 shown {1000000 // fps} us" for i in range(frames)] + ["done"]
if lines != expected:
    print(out)
    sys.exit("FAILED: the browser does not see the frames that were drawn")
print(f"{frames} frames of {frames} are the same in the browser, each shown for {1000 / fps:g} ms: {version}, {datetime.date.today()}")
