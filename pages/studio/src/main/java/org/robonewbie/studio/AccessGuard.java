package org.robonewbie.studio;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Collectors;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.http.HttpStatus;
import org.eclipse.jetty.io.Content;
import org.eclipse.jetty.server.Handler;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;
import org.jspecify.annotations.Nullable;

/**
 * Outermost HTTP handler: signs browsers in, rejects the requests that {@link AccessRule} refuses, and sets the
 * security headers.
 */
final class AccessGuard extends Handler.Wrapper {

    private static final String USED_UP = """
            <!doctype html>
            <html lang="en"><meta charset="utf-8"><title>RoboNewbie Studio</title>
            <link rel="icon" href="/icon.svg" type="image/svg+xml">
            <link rel="stylesheet" href="/theme.css"><link rel="stylesheet" href="/layout.css">
            <header class="bar"><p class="brand"><img src="/icon.svg" alt="" width="28" height="28">RoboNewbie</p></header>
            <main class="used-up">
            <h1>This address has already been used</h1>
            <p>Each address works only once and expires after ten minutes.
            For a new one, press <kbd>Enter</kbd> in the terminal in which RoboNewbie is running, or restart RoboNewbie.</p>
            <p>The studio may <a href="/">already be open</a> in this browser.</p>
            </main>
            """;

    private final AccessRule rule;
    private final SignIn signIn;
    private final String contentSecurityPolicy;

    AccessGuard(AccessRule rule, SignIn signIn, String contentSecurityPolicy, Handler protectedHandler) {
        super(protectedHandler);
        this.rule = rule;
        this.signIn = signIn;
        this.contentSecurityPolicy = contentSecurityPolicy;
    }

    @Override
    public boolean handle(Request request, Response response, Callback callback) throws Exception {
        boolean isSignedIn = isSignedIn(request);
        Optional<String> refusal = rule.refusal(
                request.getMethod(),
                header(request, HttpHeader.HOST),
                header(request, HttpHeader.ORIGIN),
                orEmpty(request.getHeaders().get("Sec-Fetch-Site")),
                Request.getPathInContext(request),
                isSignedIn);
        response.getHeaders()
                .put("Content-Security-Policy", contentSecurityPolicy)
                .put("Referrer-Policy", "no-referrer")
                .put("X-Content-Type-Options", "nosniff")
                .put("Cross-Origin-Resource-Policy", "same-origin");
        if (refusal.isPresent()) {
            answer(response, HttpStatus.FORBIDDEN_403, "text/plain;charset=utf-8", refusal.get(), callback);
            return true;
        }
        String code = request.getMethod().equals("GET")
                ? Request.extractQueryParameters(request).getValue(SignIn.CODE)
                : null;
        if (code != null) {
            exchange(request, response, code, isSignedIn, callback);
            return true;
        }
        return super.handle(request, response, callback);
    }

    /** Redeems the one-time code in an address and redirects to the same page without the code. */
    private void exchange(Request request, Response response, String code, boolean isSignedIn, Callback callback) {
        response.getHeaders().put(HttpHeader.CACHE_CONTROL, "no-store");
        boolean isNew = signIn.redeem(code);
        if (!isNew && !isSignedIn) {
            answer(response, HttpStatus.FORBIDDEN_403, "text/html;charset=utf-8", USED_UP, callback);
            return;
        }
        String query = Arrays.stream(orEmpty(request.getHttpURI().getQuery()).split("&"))
                .filter(option -> !option.startsWith(SignIn.CODE + "="))
                .collect(Collectors.joining("&"));
        String page = "http://" + header(request, HttpHeader.HOST)
                + request.getHttpURI().getPath();
        response.setStatus(HttpStatus.SEE_OTHER_303);
        response.getHeaders()
                .put(HttpHeader.LOCATION, page + (query.isEmpty() ? "" : "?" + query))
                .put(HttpHeader.SET_COOKIE, signIn.cookie());
        Content.Sink.write(response, true, "", callback);
    }

    private boolean isSignedIn(Request request) {
        return Request.getCookies(request).stream()
                .filter(cookie -> cookie.getName().equals(signIn.cookieName()))
                .anyMatch(cookie -> signIn.admits(cookie.getValue()));
    }

    private static void answer(Response response, int status, String type, String text, Callback callback) {
        response.setStatus(status);
        response.getHeaders().put(HttpHeader.CONTENT_TYPE, type);
        Content.Sink.write(response, true, text, callback);
    }

    private static String header(Request request, HttpHeader name) {
        return orEmpty(request.getHeaders().get(name));
    }

    private static String orEmpty(@Nullable String text) {
        return text == null ? "" : text;
    }
}
