package org.robonewbie.app.marking;

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
 * The key with which a judge signs the marks that it keeps (HMAC-SHA256, RFC 2104), so that a mark that a program has written counts as
 * none. It lies in the home folder, readable for its owner only: programs that run as the owner can read it, too.
 */
final class JudgesKey {

    private static final String ALGORITHM = "HmacSHA256";
    private static final int BYTES = 32;

    private final byte[] key;

    private JudgesKey(byte[] key) {
        this.key = key.clone();
    }

    /** The key of this user. */
    static JudgesKey ofUser() {
        return of(Path.of(System.getProperty("user.home", "."), ".robonewbie", "judges-key"));
    }

    /** The key in a file, which is made if it does not exist; where it cannot be kept, it lasts as long as this program. */
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

    /** Of two judges that begin at the same time the first one decides. */
    private static void keep(byte[] fresh, Path file) throws IOException {
        Path folder = Files.createDirectories(Objects.requireNonNull(file.getParent()));
        Path draft = Files.createTempFile(folder, "judges-key", ".new"); // only its owner may read it
        try {
            Files.writeString(draft, HexFormat.of().formatHex(fresh));
            Files.move(draft, file);
        } catch (FileAlreadyExistsException other) {
            Files.delete(draft);
        } finally {
            Files.deleteIfExists(draft);
        }
    }

    /** Signs a text. */
    String sign(String text) {
        try {
            Mac mac = Mac.getInstance(ALGORITHM);
            mac.init(new SecretKeySpec(key, ALGORITHM));
            return HexFormat.of().formatHex(mac.doFinal(text.getBytes(StandardCharsets.UTF_8)));
        } catch (GeneralSecurityException impossible) {
            throw new IllegalStateException(
                    "This Java has no " + ALGORITHM + ", which each Java must have", impossible);
        }
    }

    /** Whether a signature is that of a text. */
    boolean hasSigned(String text, String signature) {
        return MessageDigest.isEqual(
                sign(text).getBytes(StandardCharsets.UTF_8), signature.getBytes(StandardCharsets.UTF_8));
    }
}
