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
 * One-time sign-in codes, which the studio exchanges for a cookie. The cookie is valid for all pages of the browser.
 * Its name contains the port, because browsers send a host's cookies to all of its ports. Thread-safe.
 *
 * <pre>{@code
 * String code = signIn.newCode();
 * boolean first = signIn.redeem(code);  // true
 * boolean again = signIn.redeem(code);  // false
 * }</pre>
 */
final class SignIn {

    /** Query parameter that holds the code. */
    static final String CODE = "code";

    /** Lifetime of an unused code. */
    static final Duration LIFETIME = Duration.ofMinutes(10);

    private final String cookieName;
    private final String cookieValue;
    private final InstantSource clock;
    private final Map<String, Instant> codes = new HashMap<>();

    /**
     * Creates the sign-in service of one studio.
     *
     * @param token the user's secret
     * @param port TCP port of the studio
     * @param clock source of the current time
     */
    SignIn(AccessToken token, int port, InstantSource clock) {
        this.cookieName = "robonewbie-studio-" + port;
        this.cookieValue = token.secretOf(port);
        this.clock = clock;
    }

    /** Returns a new code, valid once within {@link #LIFETIME}. */
    synchronized String newCode() {
        forgetOld();
        String code = AccessToken.randomDigits();
        codes.put(code, clock.instant().plus(LIFETIME));
        return code;
    }

    /**
     * Returns an address with a new code.
     *
     * @param page address of a page without a query
     */
    URI newAddress(URI page) {
        return URI.create(page + "?" + CODE + "=" + newCode());
    }

    /**
     * Redeems a code.
     *
     * @param shown the code from an address
     * @return whether it was valid and unused
     */
    synchronized boolean redeem(String shown) {
        forgetOld();
        return codes.keySet().removeIf(code -> isSame(code, shown));
    }

    private void forgetOld() {
        Instant now = clock.instant();
        codes.values().removeIf(end -> !end.isAfter(now));
    }

    String cookieName() {
        return cookieName;
    }

    /** Returns whether the value of the cookie {@link #cookieName} is correct. */
    boolean admits(String shownValue) {
        return isSame(cookieValue, shownValue);
    }

    /** Returns the value of the Set-Cookie header; scripts cannot read the cookie. */
    String cookie() {
        return cookieName + "=" + cookieValue + "; Path=/; HttpOnly; SameSite=Strict; Max-Age="
                + AccessToken.LIFETIME.toSeconds();
    }

    /** Compares in constant time. */
    private static boolean isSame(String secret, String shown) {
        return MessageDigest.isEqual(secret.getBytes(StandardCharsets.UTF_8), shown.getBytes(StandardCharsets.UTF_8));
    }
}
