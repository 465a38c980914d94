package org.robonewbie.studio.file;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;
import org.jspecify.annotations.Nullable;

/**
 * HTTP response of the studio's API. Never cached.
 *
 * @param status the HTTP status
 * @param type the media type
 * @param content the body
 * @param version version of the file that was read or written; empty for other responses
 */
@SuppressWarnings("ArrayRecordComponent")
public record Answer(int status, String type, byte[] content, String version) {

    private static final String TEXT = "text/plain;charset=utf-8";

    /**
     * Creates a JSON response.
     *
     * @param text the JSON
     * @return the response
     */
    public static Answer json(String text) {
        return of("application/json", bytes(text));
    }

    /**
     * Creates a plain-text response.
     *
     * @param text the text
     * @return the response
     */
    public static Answer text(String text) {
        return of(TEXT, bytes(text));
    }

    /**
     * Creates a response from bytes that are not a versioned file.
     *
     * @param type the media type
     * @param content the body
     * @return the response
     */
    public static Answer of(String type, byte[] content) {
        return new Answer(200, type, content, "");
    }

    /**
     * Creates a response from a file, with its version.
     *
     * @param content contents of the file
     * @return the response
     */
    public static Answer file(byte[] content) {
        return new Answer(200, "application/octet-stream", content, FileVersion.of(content));
    }

    /**
     * Creates the response to a request that has written a file.
     *
     * @param version the new version of the file
     * @return the response
     */
    public static Answer written(String version) {
        return new Answer(200, TEXT, new byte[0], version);
    }

    /** {@return an empty successful response} */
    public static Answer done() {
        return text("");
    }

    /**
     * Creates an error response.
     *
     * @param status the HTTP status
     * @param reason the problem and its remedy; null for an exception without a message
     * @return the response
     */
    public static Answer refused(int status, @Nullable String reason) {
        return new Answer(status, TEXT, bytes(String.valueOf(reason)), "");
    }

    /**
     * Sends the response.
     *
     * @param response the destination
     * @param callback completed when the response has been sent
     */
    public void send(Response response, Callback callback) {
        response.setStatus(status);
        response.getHeaders()
                .put(HttpHeader.CONTENT_TYPE, type)
                .put(HttpHeader.CACHE_CONTROL, "no-store")
                .put("Version", version);
        response.write(true, ByteBuffer.wrap(content), callback);
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }
}
