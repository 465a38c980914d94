package org.robonewbie.studio;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.security.SecureRandom;
import java.time.Duration;
import java.time.Instant;
import java.util.HexFormat;
import java.util.regex.Pattern;

/**
 * The secret of one user from which the cookies of studios are derived: 128 random bits that leave neither this process nor the
 * file in which they are kept.
 *
 * <p>It is the same in all runs of a day, in a file that only this user can read, so that an open page finds back to a simulator
 * that was started again.
 *
 * @param text 32 hexadecimal digits
 */
public record AccessToken(String text) {

    private static final int BYTES = 16;
    private static final Pattern FORM = Pattern.compile("[0-9a-f]{32}");
    /** How long a kept token lasts, and with it the cookies. */
    static final Duration LIFETIME = Duration.ofDays(1);

    /**
     * Checks the form.
     *
     * @throws IllegalArgumentException if the text is not 32 hexadecimal digits
     */
    public AccessToken {
        if (!FORM.matcher(text).matches()) {
            throw new IllegalArgumentException("An access token has 32 hexadecimal digits, not \"" + text + "\".");
        }
    }

    /**
     * Draws a new token.
     *
     * @return a random token that cannot be guessed
     */
    public static AccessToken random() {
        return new AccessToken(randomDigits());
    }

    /** Draws 128 random bits as hexadecimal digits. */
    static String randomDigits() {
        byte[] bytes = new byte[BYTES];
        new SecureRandom().nextBytes(bytes);
        return HexFormat.of().formatHex(bytes);
    }

    /**
     * Takes the token of this user, kept in {@code .robonewbie/studio-token} in the home directory.
     *
     * @return the kept token, or a new one if none can be kept there
     */
    public static AccessToken ofUser() {
        Path file = Path.of(System.getProperty("user.home", "."), ".robonewbie", "studio-token");
        try {
            return keptIn(file, Instant.now());
        } catch (IOException e) {
            return random();
        }
    }

    /**
     * Takes the token that a file holds; draws and writes one if there is none, or it is damaged or older than a day.
     *
     * @param file where the token is kept
     * @param now the present time
     * @return the kept token
     * @throws IOException if the file can neither be read nor written
     */
    static AccessToken keptIn(Path file, Instant now) throws IOException {
        if (Files.isRegularFile(file)
                && Files.getLastModifiedTime(file).toInstant().plus(LIFETIME).isAfter(now)) {
            String text = Files.readString(file, StandardCharsets.ISO_8859_1).strip();
            if (FORM.matcher(text).matches()) {
                return new AccessToken(text);
            }
        }
        AccessToken token = random();
        write(file, token);
        return token;
    }

    private static void write(Path file, AccessToken token) throws IOException {
        Path folder = Files.createDirectories(file.toAbsolutePath().getParent());
        Path draft = Files.createTempFile(folder, "studio-token", ".new");
        if (Files.getFileAttributeView(draft, PosixFileAttributeView.class) != null) {
            Files.setPosixFilePermissions(draft, PosixFilePermissions.fromString("rw-------"));
        }
        Files.writeString(draft, token.text() + "\n", StandardCharsets.UTF_8);
        Files.move(draft, file, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
    }

    /**
     * Derives the secret of the studio at one port. It does not reveal the token, nor the secret of another port.
     *
     * @param port TCP port of the studio
     * @return hexadecimal digits
     */
    String secretOf(int port) {
        try {
            byte[] digest = MessageDigest.getInstance("SHA-256")
                    .digest((text + " studio " + port).getBytes(StandardCharsets.UTF_8));
            return HexFormat.of().formatHex(digest, 0, BYTES);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("Every Java has SHA-256.", e);
        }
    }
}
