package org.robonewbie.exercises.marking;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.HexFormat;
import java.util.Objects;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;

/**
 * Key for signing stored grades (HMAC-SHA256, RFC 2104), so that a grade forged by a program is ignored. The key is
 * stored in the home folder and is readable only by its owner, so programs that the owner runs outside a sandbox can
 * read it too.
 */
final class JudgesKey {

    private static final String ALGORITHM = "HmacSHA256";
    private static final int BYTES = 32;

    private final byte[] key;

    private JudgesKey(byte[] key) {
        this.key = key.clone();
    }

    /** Returns the current user's key. */
    static JudgesKey ofUser() {
        return of(Path.of(System.getProperty("user.home", "."), ".robonewbie", "judges-key"));
    }

    /**
     * Returns the key in a file, which is created if it does not exist. If the key cannot be stored, it is valid only
     * for the lifetime of this process.
     */
    static JudgesKey of(Path file) {
        byte[] fresh = new byte[BYTES];
        new SecureRandom().nextBytes(fresh);
        try {
            if (!Files.exists(file)) {
                keep(fresh, file);
            }
            return new JudgesKey(HexFormat.of().parseHex(Files.readString(file)));
        } catch (IOException | IllegalArgumentException unreadable) {
            return new JudgesKey(fresh);
        }
    }

    /** Stores a new key, unless another process has just stored one. */
    private static void keep(byte[] fresh, Path file) throws IOException {
        Path folder = Files.createDirectories(Objects.requireNonNull(file.getParent()));
        Path draft = Files.createTempFile(folder, "judges-key", ".new"); // readable only by its owner
        try {
            Files.writeString(draft, HexFormat.of().formatHex(fresh));
            Files.move(draft, file);
        } catch (FileAlreadyExistsException other) {
            Files.delete(draft);
        } finally {
            Files.deleteIfExists(draft);
        }
    }

    String sign(String text) {
        try {
            Mac mac = Mac.getInstance(ALGORITHM);
            mac.init(new SecretKeySpec(key, ALGORITHM));
            return HexFormat.of().formatHex(mac.doFinal(text.getBytes(StandardCharsets.UTF_8)));
        } catch (GeneralSecurityException impossible) {
            throw new IllegalStateException(
                    "This Java runtime does not provide " + ALGORITHM + ", although the specification requires it",
                    impossible);
        }
    }

    /** Returns whether a signature matches the text. */
    boolean hasSigned(String text, String signature) {
        return MessageDigest.isEqual(
                sign(text).getBytes(StandardCharsets.UTF_8), signature.getBytes(StandardCharsets.UTF_8));
    }
}
