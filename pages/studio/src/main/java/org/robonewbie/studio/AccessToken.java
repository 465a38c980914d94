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
 * One user's secret, from which the cookies of all studios are derived: 128 random bits, stored only in this process and in
 * a file.
 *
 * <p>The token is kept for a day in a file that only this user can read, so that an open page can reconnect after the
 * simulator has been restarted.
 *
 * @param text 32 hexadecimal digits
 */
public record AccessToken(String text) {

    private static final int BYTES = 16;
    private static final Pattern FORM = Pattern.compile("[0-9a-f]{32}");
    /** Lifetime of a stored token and of the cookies. */
    static final Duration LIFETIME = Duration.ofDays(1);

    /**
     * Validates the format.
     *
     * @throws IllegalArgumentException if the text is not 32 hexadecimal digits
     */
    public AccessToken {
        if (!FORM.matcher(text).matches()) {
            throw new IllegalArgumentException("An access token has 32 hexadecimal digits, not \"" + text + "\".");
        }
    }

    /**
     * Generates a new token.
     *
     * @return a random token that cannot be guessed
     */
    public static AccessToken random() {
        return new AccessToken(randomDigits());
    }

    /** Returns 128 random bits as hexadecimal digits. */
    static String randomDigits() {
        byte[] bytes = new byte[BYTES];
        new SecureRandom().nextBytes(bytes);
        return HexFormat.of().formatHex(bytes);
    }

    /**
     * Loads this user's token from {@code .robonewbie/studio-token} in the home directory.
     *
     * @return the stored token, or a new one that is not saved if the file is not accessible
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
     * Loads the token from a file. Replaces it with a new one if the file is missing, malformed or older than a day.
     *
     * @param file the token file
     * @param now the current time
     * @return the stored token
     * @throws IOException if the file can be neither read nor written
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
     * Derives the secret of the studio on one port. It reveals neither the token nor the secret of another port.
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
            throw new IllegalStateException(
                    "This Java runtime does not provide SHA-256, although the specification requires it.", e);
        }
    }
}
