package org.robonewbie.studio.file;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/** By what pages know the content of a file, so that nobody overwrites what another program has written meanwhile. */
public final class FileVersion {

    private static final int BYTES = 12;

    private FileVersion() {}

    /**
     * Returns the version of a content: the same for the same bytes.
     *
     * @param content what is in the file
     * @return some letters and digits
     */
    public static String of(byte[] content) {
        try {
            return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(content), 0, BYTES);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("Every Java has SHA-256.", e);
        }
    }
}
