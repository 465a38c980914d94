package org.robonewbie.app.doctor;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.robonewbie.nao.file.TemporaryFolder;

/** Checks whether WebGL works in a headless browser; without it, the studio's 3D view is simpler and slower. */
final class GraphicsCheck {

    private static final String SUBJECT = "Graphics";
    private static final int MAX_SECONDS = 30;
    private static final String WORKS = "webgl-works";
    private static final String LOOK =
            "Check by opening the studio once on this computer (robonewbie demo). Without WebGL, its picture is simpler and drawn more slowly.";

    /** Browsers with a headless mode, as commands on the PATH or as files. */
    private static final List<String> BROWSERS = List.of(
            "chromium",
            "chromium-browser",
            "google-chrome",
            "google-chrome-stable",
            "chrome.exe",
            "msedge.exe",
            "microsoft-edge",
            "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
            "/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
            "C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe",
            "C:\\Program Files (x86)\\Microsoft\\Edge\\Application\\msedge.exe");

    private static final String PAGE = """
            <!DOCTYPE html><title>RoboNewbie</title><body><script>
            const there = document.createElement('canvas').getContext('webgl2');
            document.body.textContent = there ? 'webgl' + '-works' : 'webgl' + '-is-missing';
            </script>
            """;

    private GraphicsCheck() {}

    static Finding drawn() {
        return drawn(Optional.ofNullable(System.getenv("PATH")).orElse(""));
    }

    static Finding drawn(String searchPath) {
        Optional<Path> browser = browser(searchPath);
        if (browser.isEmpty()) {
            return Finding.notable(SUBJECT, "no Chromium-based browser found for this check", LOOK);
        }
        try (TemporaryFolder folder = TemporaryFolder.create("graphics")) {
            Path page = Files.writeString(folder.path().resolve("page.html"), PAGE);
            String shown = answer(browser.get(), folder.path(), page);
            return shown.contains(WORKS)
                    ? Finding.well(SUBJECT, browser.get().getFileName() + " supports 3D graphics (WebGL)")
                    : Finding.notable(SUBJECT, browser.get() + " does not support 3D graphics (WebGL)", LOOK);
        } catch (IOException failed) {
            return Finding.notable(SUBJECT, browser.get() + " did not start: " + failed.getMessage(), LOOK);
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            return Finding.notable(SUBJECT, "not checked", "The check was interrupted.");
        }
    }

    private static String answer(Path browser, Path folder, Path page) throws IOException, InterruptedException {
        Path shown = folder.resolve("shown.html");
        Process process = new ProcessBuilder(
                        browser.toString(),
                        "--headless=new",
                        "--no-first-run",
                        "--user-data-dir=" + folder.resolve("profile"),
                        "--dump-dom",
                        page.toUri().toString())
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .redirectOutput(shown.toFile())
                .start();
        try {
            process.waitFor(MAX_SECONDS, TimeUnit.SECONDS);
            return Files.readString(shown);
        } finally {
            end(process);
        }
    }

    private static void end(Process process) {
        process.descendants().forEach(ProcessHandle::destroyForcibly);
        process.destroyForcibly();
    }

    private static Optional<Path> browser(String searchPath) {
        return BROWSERS.stream()
                .flatMap(name -> name.contains("/") || name.contains("\\")
                        ? Stream.of(new File(name).toPath())
                        : Arrays.stream(searchPath.split(File.pathSeparator)).map(folder -> Path.of(folder, name)))
                .filter(Files::isExecutable)
                .findFirst();
    }
}
