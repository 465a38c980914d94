package org.robonewbie.studio;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.http.HttpStatus;
import org.eclipse.jetty.server.Handler;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;

/**
 * Static file handler for the studio's pages and the documentation, both from the class path. Paths consist of plain
 * names, so no path can leave the folder {@code web}.
 */
final class WebFiles extends Handler.Abstract {

    private static final String START_PAGE = "index.html";

    /** Address prefix of the documentation. */
    private static final String DOCUMENTATION = "docs/";

    private static final String DOCUMENTATION_PAGES = "/org/robonewbie/site/pages/";
    private static final Pattern PATH = Pattern.compile("/((?:[a-z0-9-]+/)*[a-z0-9-]+(?:\\.[a-z0-9]+)*\\.([a-z]+))");
    private static final Pattern IMPORT_MAP =
            Pattern.compile("<script type=\"importmap\">(.*?)</script>", Pattern.DOTALL);
    private static final Pattern LINK = Pattern.compile("<(?:link|script)[^>]* (?:href|src)=\"([^\"]+)\"");
    private static final Map<String, String> TYPES = Map.of(
            "html", "text/html;charset=utf-8",
            "css", "text/css;charset=utf-8",
            "js", "text/javascript;charset=utf-8",
            "svg", "image/svg+xml",
            "png", "image/png");

    private final Map<String, WebFile> files = new ConcurrentHashMap<>();

    @Override
    public boolean handle(Request request, Response response, Callback callback) throws Exception {
        String path = Request.getPathInContext(request);
        Matcher matcher = PATH.matcher(path.endsWith("/") ? path + START_PAGE : path);
        if (!matcher.matches() || !TYPES.containsKey(matcher.group(2))) {
            return false;
        }
        Optional<WebFile> found = file(matcher.group(1));
        if (found.isEmpty()) {
            return false;
        }
        WebFile file = found.get();
        response.getHeaders()
                .put(HttpHeader.CONTENT_TYPE, TYPES.get(matcher.group(2)))
                .put(HttpHeader.CACHE_CONTROL, "no-cache")
                .put(HttpHeader.ETAG, file.tag());
        if (file.tag().equals(request.getHeaders().get(HttpHeader.IF_NONE_MATCH))) {
            response.setStatus(HttpStatus.NOT_MODIFIED_304);
            response.write(true, ByteBuffer.allocate(0), callback);
            return true;
        }
        response.getHeaders().put(HttpHeader.CONTENT_LENGTH, file.content().length);
        boolean withBody = !request.getMethod().equals("HEAD");
        response.write(true, ByteBuffer.wrap(withBody ? file.content() : new byte[0]), callback);
        return true;
    }

    /** Loads the start page and its scripts into the cache. */
    void warmUp() {
        String page = file(START_PAGE).map(WebFile::text).orElse("");
        LINK.matcher(page).results().forEach(link -> file(link.group(1)));
    }

    /** Returns a file, cached after the first access. Adds preload links for scripts to pages. */
    private Optional<WebFile> file(String name) {
        WebFile kept = files.get(name);
        if (kept != null) {
            return Optional.of(kept);
        }
        Optional<WebFile> read = read(name).map(WebFile::of).map(file -> isPage(name) ? withPreloads(file) : file);
        read.ifPresent(file -> files.put(name, file));
        return read;
    }

    private static boolean isPage(String name) {
        return name.endsWith(".html") && !name.contains("/");
    }

    private WebFile withPreloads(WebFile page) {
        ModuleGraph scripts = new ModuleGraph(name -> file(name).map(WebFile::text));
        return WebFile.of(scripts.withPreloads(page.text()).getBytes(StandardCharsets.UTF_8));
    }

    /**
     * Returns the Content-Security-Policy: only this server's files and its live feed may be loaded. The start page's import map is
     * the only inline script and is allowed by its hash.
     *
     * @param port the server's port
     * @return the value of the header
     */
    static String contentSecurityPolicy(int port) {
        return "default-src 'none'; script-src 'self' 'sha256-" + importMapHash() + "'; style-src 'self'; "
                + "img-src 'self' data: blob:; connect-src 'self' ws://127.0.0.1:" + port + " ws://localhost:" + port
                + "; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
    }

    private static String importMapHash() {
        String page = read(START_PAGE)
                .map(bytes -> new String(bytes, StandardCharsets.UTF_8))
                .orElseThrow();
        Matcher matcher = IMPORT_MAP.matcher(page);
        if (!matcher.find()) {
            throw new IllegalStateException(START_PAGE + " has no import map.");
        }
        return WebFile.hash(matcher.group(1).getBytes(StandardCharsets.UTF_8));
    }

    private static Optional<byte[]> read(String name) {
        String resource = name.startsWith(DOCUMENTATION)
                ? DOCUMENTATION_PAGES + name.substring(DOCUMENTATION.length())
                : "web/" + name;
        try (InputStream stream = WebFiles.class.getResourceAsStream(resource)) {
            return stream == null ? Optional.empty() : Optional.of(stream.readAllBytes());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
