package org.robonewbie.studio;

import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.HashMap;
import java.util.Map;

/**
 * Signs browsers in: an address holds a code for one use, which a studio exchanges for a cookie. The cookie serves all pages of that
 * browser; its name holds the port, since browsers send the cookies of a computer to all of its ports. Thread-safe.
 *
 * <pre>{@code
 * String code = signIn.newCode();
 * boolean first = signIn.redeem(code);  // true
 * boolean again = signIn.redeem(code);  // false
 * }</pre>
 */
final class SignIn {

    /** Parameter of an address that holds a code. */
    static final String CODE = "code";

    /** How long a code that was not used can be. */
    static final Duration LIFETIME = Duration.ofMinutes(10);

    private final String cookieName;
    private final String cookieValue;
    private final InstantSource clock;
    private final Map<String, Instant> codes = new HashMap<>();

    /**
     * Creates the sign-in of a studio.
     *
     * @param token the user's secret
     * @param port TCP port of the studio
     * @param clock decides when a code is too old
     */
    SignIn(AccessToken token, int port, InstantSource clock) {
        this.cookieName = "robonewbie-studio-" + port;
        this.cookieValue = token.secretOf(port);
        this.clock = clock;
    }

    /** Returns a new code, which can be used once within {@link #LIFETIME}. */
    synchronized String newCode() {
        forgetOld();
        String code = AccessToken.randomDigits();
        codes.put(code, clock.instant().plus(LIFETIME));
        return code;
    }

    /**
     * Returns an address with a new code.
     *
     * @param page the address of a page without a query
     */
    URI newAddress(URI page) {
        return URI.create(page + "?" + CODE + "=" + newCode());
    }

    /**
     * Uses a code up.
     *
     * @param shown what an address holds
     * @return whether it was a code that nothing has used before
     */
    synchronized boolean redeem(String shown) {
        forgetOld();
        return codes.keySet().removeIf(code -> isSame(code, shown));
    }

    private void forgetOld() {
        Instant now = clock.instant();
        codes.values().removeIf(end -> !end.isAfter(now));
    }

    /** Name of the cookie. */
    String cookieName() {
        return cookieName;
    }

    /** Whether a cookie of {@link #cookieName} has the right value. */
    boolean admits(String shownValue) {
        return isSame(cookieValue, shownValue);
    }

    /** The value of the header Set-Cookie: a cookie that no script can read. */
    String cookie() {
        return cookieName + "=" + cookieValue + "; Path=/; HttpOnly; SameSite=Strict; Max-Age="
                + AccessToken.LIFETIME.toSeconds();
    }

    /** Compares in a time that does not reveal where the difference is. */
    private static boolean isSame(String secret, String shown) {
        return MessageDigest.isEqual(secret.getBytes(StandardCharsets.UTF_8), shown.getBytes(StandardCharsets.UTF_8));
    }
}
