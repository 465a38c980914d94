package org.robonewbie.studio;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/** Static file server below a path, like any web host. */
final class StaticServer implements AutoCloseable {

    private static final String PLACE = "/some/where/";
    private static final Map<String, String> TYPES = Map.of(
            "html", "text/html",
            "js", "text/javascript",
            "css", "text/css",
            "json", "application/json",
            "svg", "image/svg+xml",
            "wasm", "application/wasm");
    private static final int THREADS = 4;

    private final List<Path> folders;
    private final ExecutorService threads = Executors.newFixedThreadPool(THREADS);
    private final HttpServer server;

    /** Files of an earlier folder take precedence over those of a later one. */
    StaticServer(Path... folders) throws IOException {
        this.folders = List.of(folders);
        server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        server.createContext(PLACE, this::answer);
        server.setExecutor(threads);
        server.start();
    }

    String address() {
        return "http://127.0.0.1:" + server.getAddress().getPort() + PLACE;
    }

    private void answer(HttpExchange exchange) throws IOException {
        try (exchange) {
            String name = exchange.getRequestURI().getPath().substring(PLACE.length());
            Optional<Path> file = folders.stream()
                    .map(folder -> find(folder, name.isEmpty() || name.endsWith("/") ? name + "index.html" : name))
                    .flatMap(Optional::stream)
                    .findFirst();
            if (file.isEmpty()) {
                exchange.sendResponseHeaders(404, -1);
                return;
            }
            byte[] content = Files.readAllBytes(file.get());
            String ending = file.get().toString().replaceFirst(".*\\.", "");
            exchange.getResponseHeaders().set("Content-Type", TYPES.getOrDefault(ending, "application/octet-stream"));
            exchange.sendResponseHeaders(200, content.length == 0 ? -1 : content.length);
            exchange.getResponseBody().write(content);
        }
    }

    private static Optional<Path> find(Path folder, String name) {
        return Optional.of(folder.resolve(name).normalize())
                .filter(file -> file.startsWith(folder) && Files.isRegularFile(file));
    }

    @Override
    public void close() {
        server.stop(0);
        threads.shutdownNow();
    }
}
