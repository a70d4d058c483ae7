"""carom lab serves the files of the page's folder to this machine, under a strict policy, and nothing else; it ends
cleanly when it is interrupted."""

import http.client
import signal
import subprocess

from program import CAROM, ProgramTest, main

INDEX = "<!doctype html><title>A page</title>"


class Lab(ProgramTest):
    def setUp(self):
        super().setUp()
        self.path("page/assets").mkdir(parents=True)
        self.write("page/index.html", INDEX)
        self.write("page/assets/engine.wasm", b"\0asm")
        self.write("secret.txt", "not part of the page")
        self.path("page/way out").symlink_to(self.path("secret.txt"))

    def serve(self, *words):
        """The running program and its port."""
        lab = subprocess.Popen([CAROM, "lab", "--no-open", "--page", "page", *words], cwd=self.directory, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(lab.communicate)
        self.addCleanup(lab.kill)
        address = lab.stdout.readline().strip()
        self.assertRegex(address, r"^http://127\.0\.0\.1:\d+/$")
        return lab, int(address.rstrip("/").rsplit(":", 1)[1])

    def get(self, port, path, host=None):
        connection = http.client.HTTPConnection("127.0.0.1", port, timeout=20)
        self.addCleanup(connection.close)
        connection.putrequest("GET", path, skip_host=host is not None)
        if host is not None:
            connection.putheader("Host", host)
        connection.endheaders()
        answer = connection.getresponse()
        return answer.status, answer.read(), answer.headers

    def test_serves_the_page(self):
        _, port = self.serve("--port", "0")
        for path in ("/", "/index.html"):
            status, body, headers = self.get(port, path)
            self.assertEqual((status, body.decode()), (200, INDEX))
            policy = headers["Content-Security-Policy"]
            self.assertIn("default-src 'none'", policy)
            self.assertNotIn("unsafe-inline", policy)
            self.assertNotIn("'unsafe-eval'", policy)
        status, body, headers = self.get(port, "/assets/engine.wasm")
        self.assertEqual((status, body, headers["Content-Type"]), (200, b"\0asm", "application/wasm"))

    def test_serves_nothing_else(self):
        _, port = self.serve("--port", "0")
        for path in ("/../secret.txt", "/%2e%2e/secret.txt", "/..%2fsecret.txt", "/assets/../../secret.txt", "/assets",
                     "/way out".replace(" ", "%20"), "//etc/passwd", "/no such file".replace(" ", "+")):
            with self.subTest(path=path):
                self.assertEqual(self.get(port, path)[0], 404)
        for host in ("example.org", f"example.org:{port}", "127.0.0.1"):
            with self.subTest(host=host):
                self.assertEqual(self.get(port, "/", host)[0], 403)
        self.assertEqual(self.get(port, "/", f"localhost:{port}")[0], 200)

    def test_ends_when_interrupted(self):
        for how in (signal.SIGINT, signal.SIGTERM):
            lab, port = self.serve("--port", "0")
            self.assertEqual(self.get(port, "/")[0], 200)
            lab.send_signal(how)
            _, errors = lab.communicate(timeout=20)
            self.assertEqual((lab.returncode, errors), (0, ""))

    def test_refuses_what_it_cannot_serve(self):
        _, port = self.serve("--port", "0")
        self.refuse(["lab", "--no-open", "--page", "page", "--port", port], 1, str(port), "taken")
        self.refuse(["lab", "--no-open", "--page", "page", "--port", 70000], 2, "70000")
        self.refuse(["lab", "--no-open", "--page", "nowhere"], 1, "nowhere", "index.html")


if __name__ == "__main__":
    main()
