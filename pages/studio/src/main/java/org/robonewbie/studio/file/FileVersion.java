package org.robonewbie.studio.file;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/** Content hash of a file for optimistic locking: a page never overwrites a change that it has not read. */
public final class FileVersion {

    private static final int BYTES = 12;

    private FileVersion() {}

    /**
     * Computes the version; equal bytes have equal versions.
     *
     * @param content contents of the file
     * @return hexadecimal digits
     */
    public static String of(byte[] content) {
        try {
            return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(content), 0, BYTES);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(
                    "This Java runtime does not provide SHA-256, although the specification requires it.", e);
        }
    }
}
