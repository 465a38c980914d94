package org.robonewbie.studio;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/** Process of a headless browser with its own profile. */
final class BrowserProcess implements AutoCloseable {

    private final Process process;
    private final Path profile;
    private final URI devTools;

    private BrowserProcess(Process process, Path profile, URI devTools) {
        this.process = process;
        this.profile = profile;
        this.devTools = devTools;
    }

    /** Starts the browser and waits until it accepts commands. */
    static BrowserProcess start() throws IOException {
        Path profile = Files.createTempDirectory("studio-chromium");
        List<String> command = new ArrayList<>();
        command.add(Tool.BROWSER.find().orElseThrow().toString());
        command.addAll(List.of(
                "--headless=new",
                "--no-sandbox",
                "--disable-dev-shm-usage",
                "--disable-gpu", // software emulation of a graphics card takes most of the time
                "--enable-unsafe-swiftshader",
                "--remote-debugging-port=0",
                "--no-first-run",
                "--disable-extensions",
                "--disable-background-networking",
                "--disable-background-timer-throttling",
                "--disable-backgrounding-occluded-windows",
                "--disable-renderer-backgrounding",
                "--user-data-dir=" + profile,
                "about:blank"));
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        return new BrowserProcess(process, profile, devTools(process));
    }

    private static URI devTools(Process process) throws IOException {
        BufferedReader output =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
        String announcement = "DevTools listening on ";
        for (String line = output.readLine(); line != null; line = output.readLine()) {
            if (line.startsWith(announcement)) {
                drain(output);
                return URI.create(line.substring(announcement.length()).strip());
            }
        }
        throw new IOException("The browser did not start.");
    }

    private static void drain(BufferedReader output) {
        Thread reader = new Thread(() -> readAll(output), "chromium-output");
        reader.setDaemon(true);
        reader.start();
    }

    private static void readAll(BufferedReader output) {
        try {
            output.transferTo(Writer.nullWriter());
        } catch (IOException browserIsClosed) {
            return;
        }
    }

    /** Returns the address of the DevTools endpoint. */
    URI devTools() {
        return devTools;
    }

    /** Returns the CPU time of the browser with all its processes. */
    double processorSeconds() {
        return Stream.concat(Stream.of(process.toHandle()), process.descendants())
                .flatMap(each -> each.info().totalCpuDuration().stream())
                .mapToDouble(work -> work.toMillis() / 1000.0)
                .sum();
    }

    @Override
    public void close() {
        process.descendants().forEach(ProcessHandle::destroyForcibly);
        process.destroyForcibly();
        try {
            process.waitFor(10, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        try (Stream<Path> files = Files.walk(profile)) {
            files.sorted(Comparator.reverseOrder())
                    .forEach(file -> file.toFile().delete());
        } catch (IOException | UncheckedIOException e) {
            // The operating system cleans up its temporary folder.
        }
    }
}
