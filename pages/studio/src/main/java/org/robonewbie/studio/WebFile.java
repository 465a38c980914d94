package org.robonewbie.studio;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;

/** Static file with its ETag. */
@SuppressWarnings("ArrayRecordComponent")
record WebFile(byte[] content, String tag) {

    static WebFile of(byte[] content) {
        return new WebFile(content, "\"" + hash(content) + "\"");
    }

    /** Returns the SHA-256 hash in Base64, as used in a Content-Security-Policy. */
    static String hash(byte[] content) {
        try {
            return Base64.getEncoder()
                    .encodeToString(MessageDigest.getInstance("SHA-256").digest(content));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(
                    "This Java runtime does not provide SHA-256, although the specification requires it.", e);
        }
    }

    String text() {
        return new String(content, StandardCharsets.UTF_8);
    }
}
