package org.robonewbie.app.studio;

import java.io.BufferedReader;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robonewbie.programs.process.JavaCommand;
import org.robonewbie.studio.StudioCookie;

/** A studio in its own process, started as by a user, and a client for its API. */
public final class StudioProcess implements AutoCloseable {

    private static final Pattern ADDRESS = Pattern.compile("Studio: (\\S+)");

    private final Process process;
    private final URI address;
    private String cookie = "";

    private StudioProcess(Process process, URI address) {
        this.process = process;
        this.address = address;
    }

    /** Starts the studio in a working directory. */
    public static StudioProcess start(Path folder) throws IOException {
        List<String> command = List.of("studio", "--no-browser", "--agent-port", "0");
        ProcessBuilder builder = new ProcessBuilder(JavaCommand.ofCommand(command))
                .directory(folder.toFile())
                .redirectError(ProcessBuilder.Redirect.DISCARD);
        builder.environment().put("ROBONEWBIE_RECORDINGS", "off");
        Process process = builder.start();
        BufferedReader lines = process.inputReader(StandardCharsets.UTF_8);
        for (String line = lines.readLine(); line != null; line = lines.readLine()) {
            Matcher matcher = ADDRESS.matcher(line);
            if (matcher.find()) {
                return new StudioProcess(process, URI.create(matcher.group(1)));
            }
        }
        throw new IOException("The studio exited without printing an address.");
    }

    /** Sends a request and returns the complete response. */
    public synchronized String ask(String order, String place, String body, String... headers) throws IOException {
        cookie = cookie.isEmpty() ? StudioCookie.of(address) : cookie;
        List<String> lines = new ArrayList<>(List.of(
                order + " /api/" + place + " HTTP/1.1",
                "Host: " + address.getAuthority(),
                "Origin: http://" + address.getAuthority(),
                "Cookie: " + cookie,
                "Content-Length: " + body.length(),
                "Connection: close"));
        lines.addAll(List.of(headers));
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), address.getPort())) {
            socket.getOutputStream()
                    .write((String.join("\r\n", lines) + "\r\n\r\n" + body).getBytes(StandardCharsets.US_ASCII));
            return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    /** Kills the process as {@code kill -9} does. */
    void kill() throws InterruptedException {
        process.destroyForcibly().waitFor();
    }

    @Override
    public void close() {
        process.destroyForcibly();
    }
}
