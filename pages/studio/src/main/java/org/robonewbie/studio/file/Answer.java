package org.robonewbie.studio.file;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;
import org.jspecify.annotations.Nullable;

/**
 * What a page gets when it asks the studio for something. No browser keeps it.
 *
 * @param status the HTTP status
 * @param type the media type
 * @param content what is sent
 * @param version the version of the file that is sent or has been written; empty for all else
 */
@SuppressWarnings("ArrayRecordComponent")
public record Answer(int status, String type, byte[] content, String version) {

    private static final String TEXT = "text/plain;charset=utf-8";

    /**
     * Answers with JSON.
     *
     * @param text the JSON
     * @return the answer
     */
    public static Answer json(String text) {
        return of("application/json", bytes(text));
    }

    /**
     * Answers with a text.
     *
     * @param text the text
     * @return the answer
     */
    public static Answer text(String text) {
        return of(TEXT, bytes(text));
    }

    /**
     * Answers with a content that is no file of the user.
     *
     * @param type the media type
     * @param content the content
     * @return the answer
     */
    public static Answer of(String type, byte[] content) {
        return new Answer(200, type, content, "");
    }

    /**
     * Answers with a file, and with the version by which the page knows it.
     *
     * @param content what is in the file
     * @return the answer
     */
    public static Answer file(byte[] content) {
        return new Answer(200, "application/octet-stream", content, FileVersion.of(content));
    }

    /**
     * Answers that a file is written.
     *
     * @param version the version that it has now
     * @return the answer
     */
    public static Answer written(String version) {
        return new Answer(200, TEXT, new byte[0], version);
    }

    /** {@return the answer that something without a result is done} */
    public static Answer done() {
        return text("");
    }

    /**
     * Refuses.
     *
     * @param status the HTTP status
     * @param reason what was refused, and what to do; null stands for a failure without words
     * @return the answer
     */
    public static Answer refused(int status, @Nullable String reason) {
        return new Answer(status, TEXT, bytes(String.valueOf(reason)), "");
    }

    /**
     * Sends the answer.
     *
     * @param response where to
     * @param callback told when it is sent
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
