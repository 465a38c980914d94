package org.robonewbie.studio;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.HexFormat;
import java.util.regex.Pattern;

/**
 * The secret that a page must show before it may steer a simulation: 128 random bits.
 *
 * <p>It is the same in all runs of one user, kept in a file that only this user can read, so that an open page finds back
 * to a simulator that was started again.
 *
 * @param text 32 hexadecimal digits
 */
public record AccessToken(String text) {

    private static final int BYTES = 16;
    private static final Pattern FORM = Pattern.compile("[0-9a-f]{32}");

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
        byte[] bytes = new byte[BYTES];
        new SecureRandom().nextBytes(bytes);
        return new AccessToken(HexFormat.of().formatHex(bytes));
    }

    /**
     * Takes the token of this user, kept in {@code .robonewbie/studio-token} in the home directory.
     *
     * @return the kept token, or a new one if none can be kept there
     */
    public static AccessToken ofUser() {
        Path file = Path.of(System.getProperty("user.home", "."), ".robonewbie", "studio-token");
        try {
            return keptIn(file);
        } catch (IOException e) {
            return random();
        }
    }

    /**
     * Takes the token that a file holds; draws and writes one if there is none or it is damaged.
     *
     * @param file where the token is kept
     * @return the kept token
     * @throws IOException if the file can neither be read nor written
     */
    static AccessToken keptIn(Path file) throws IOException {
        if (Files.isRegularFile(file)) {
            String text = Files.readString(file, StandardCharsets.UTF_8).strip();
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
     * Compares in a time that tells nothing about where the difference is.
     *
     * @param candidate what a page has shown
     * @return whether it is this token
     */
    public boolean matches(String candidate) {
        return MessageDigest.isEqual(text.getBytes(StandardCharsets.UTF_8), candidate.getBytes(StandardCharsets.UTF_8));
    }
}
