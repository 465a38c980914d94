package org.robonewbie.studio;

import java.util.Optional;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.http.HttpStatus;
import org.eclipse.jetty.io.Content;
import org.eclipse.jetty.server.Handler;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;
import org.jspecify.annotations.Nullable;

/** Stands before everything else in the server and turns away what {@link AccessRule} refuses. */
final class AccessGuard extends Handler.Wrapper {

    private final AccessRule rule;
    private final String contentSecurityPolicy;

    AccessGuard(AccessRule rule, String contentSecurityPolicy, Handler protectedHandler) {
        super(protectedHandler);
        this.rule = rule;
        this.contentSecurityPolicy = contentSecurityPolicy;
    }

    @Override
    public boolean handle(Request request, Response response, Callback callback) throws Exception {
        Optional<String> refusal = rule.refusal(
                request.getMethod(),
                header(request, HttpHeader.HOST),
                header(request, HttpHeader.ORIGIN),
                Request.getPathInContext(request),
                token(request));
        if (refusal.isPresent()) {
            response.setStatus(HttpStatus.FORBIDDEN_403);
            response.getHeaders().put(HttpHeader.CONTENT_TYPE, "text/plain;charset=utf-8");
            Content.Sink.write(response, true, refusal.get(), callback);
            return true;
        }
        response.getHeaders()
                .put("Content-Security-Policy", contentSecurityPolicy)
                .put("Referrer-Policy", "no-referrer")
                .put("X-Content-Type-Options", "nosniff")
                .put("Cross-Origin-Resource-Policy", "same-origin");
        return super.handle(request, response, callback);
    }

    /** The token comes in the address, or in a header where addresses might be noted down. */
    private static String token(Request request) {
        String header = orEmpty(request.getHeaders().get("Studio-Token"));
        return header.isEmpty()
                ? orEmpty(Request.extractQueryParameters(request).getValue("token"))
                : header;
    }

    private static String header(Request request, HttpHeader name) {
        return orEmpty(request.getHeaders().get(name));
    }

    private static String orEmpty(@Nullable String text) {
        return text == null ? "" : text;
    }
}
