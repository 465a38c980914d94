package org.robonewbie.studio;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;

/** A file that pages load, with the tag by which a browser asks whether it has changed. */
@SuppressWarnings("ArrayRecordComponent")
record WebFile(byte[] content, String tag) {

    static WebFile of(byte[] content) {
        return new WebFile(content, "\"" + hash(content) + "\"");
    }

    /** The SHA-256 hash of some bytes, as browsers write it. */
    static String hash(byte[] content) {
        try {
            return Base64.getEncoder()
                    .encodeToString(MessageDigest.getInstance("SHA-256").digest(content));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("Every Java has SHA-256.", e);
        }
    }

    String text() {
        return new String(content, StandardCharsets.UTF_8);
    }
}
