package org.robonewbie.programs;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.DigestInputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import org.robonewbie.nao.file.SubmittedFolder;

/** Checksum of everything on which a result depends, such as a program's files. */
public final class Fingerprint {

    private static final int DIGITS = 16;

    private final MessageDigest digest;

    /** Creates a checksum without any data. */
    public Fingerprint() {
        try {
            digest = MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(
                    "This Java runtime does not provide SHA-256, although the specification requires it", e);
        }
    }

    /**
     * Adds a string.
     *
     * @param text the string
     * @return this
     */
    public Fingerprint add(String text) {
        digest.update(text.getBytes(StandardCharsets.UTF_8));
        digest.update((byte) 0);
        return this;
    }

    /**
     * Adds the bytes of a stream.
     *
     * @param bytes the stream, which is read to its end
     * @return this
     * @throws IOException if it cannot be read
     */
    public Fingerprint add(InputStream bytes) throws IOException {
        digest.update(bytes.readAllBytes());
        return this;
    }

    /**
     * Adds the names and contents of all files in a submission.
     *
     * @param folder the submission
     * @return this
     * @throws IOException if a file is refused or cannot be read
     */
    public Fingerprint add(SubmittedFolder folder) throws IOException {
        for (Path file : folder.files()) {
            add(folder.root().relativize(file).toString().replace('\\', '/'));
            digest.update(Files.readAllBytes(file));
        }
        return this;
    }

    /**
     * Returns the SHA-256 hash of a file, as {@code sha256sum} prints it.
     *
     * @param file the file
     * @return 64 hexadecimal digits
     * @throws IOException if it cannot be read
     */
    public static String sha256(Path file) throws IOException {
        MessageDigest digest = new Fingerprint().digest;
        try (InputStream bytes = new DigestInputStream(Files.newInputStream(file), digest)) {
            bytes.transferTo(OutputStream.nullOutputStream());
        }
        return HexFormat.of().formatHex(digest.digest());
    }

    /** {@return the checksum of everything that has been added; call only once} */
    public String text() {
        return HexFormat.of().formatHex(digest.digest()).substring(0, DIGITS);
    }
}
