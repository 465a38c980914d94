package org.robonewbie.studio;

import java.util.Optional;
import java.util.Set;
import org.robonewbie.studio.board.EventBus;

/**
 * Access control of the studio: only pages loaded from this server as localhost or 127.0.0.1 may use it.
 *
 * <p>The Host header is checked to prevent DNS rebinding, the Origin header because any site can open a WebSocket to
 * localhost, and the cookie because other users of this computer can connect too.
 */
final class AccessRule {

    static final String LIVE_PATH = "/live";

    /** Prefix of all paths that read or write the user's files. */
    static final String WORK_PATH = "/api/";

    private static final Set<String> FOREIGN_SITES = Set.of("cross-site", "same-site");

    private final Set<String> hosts;

    AccessRule(int port) {
        this.hosts = Set.of("127.0.0.1:" + port, "localhost:" + port);
    }

    /**
     * Checks a request.
     *
     * @param method the HTTP method
     * @param host the Host header, empty if there is none
     * @param origin the Origin header, empty if there is none
     * @param site the Sec-Fetch-Site header, empty if there is none
     * @param path the requested path
     * @param isSignedIn whether the request carries the studio's cookie
     * @return the reason for the refusal, or empty if the request is allowed
     */
    Optional<String> refusal(String method, String host, String origin, String site, String path, boolean isSignedIn) {
        if (!hosts.contains(host)) {
            return Optional.of("The studio only accepts requests to "
                    + hosts.stream().sorted().toList() + ", not to \"" + host
                    + "\". Open the address that the simulator printed.");
        }
        if (!origin.isEmpty() && !origin.equals("http://" + host)) {
            return Optional.of("Pages from \"" + origin + "\" may not use the studio.");
        }
        boolean isLive = path.equals(LIVE_PATH) || path.startsWith(EventBus.PATHS);
        if (isLive || path.startsWith(WORK_PATH)) {
            return refusalOfUse(isLive, method, origin, site, isSignedIn);
        }
        if (!method.equals("GET") && !method.equals("HEAD")) {
            return Optional.of("The studio's files are read-only: " + method + " is not allowed.");
        }
        return Optional.empty();
    }

    /**
     * A page from another port on this computer also sends the cookie, but with the Sec-Fetch-Site header {@code same-site}.
     */
    private static Optional<String> refusalOfUse(
            boolean isLive, String method, String origin, String site, boolean isSignedIn) {
        if (FOREIGN_SITES.contains(site)) {
            return Optional.of("Pages from other addresses may not use the studio.");
        }
        if (isLive && origin.isEmpty()) {
            return Optional.of("Only pages of the studio may watch the simulation; this request has no Origin header.");
        }
        if (!method.equals("GET") && origin.isEmpty()) {
            return Optional.of("Only pages of the studio may change files; this request has no Origin header.");
        }
        return isSignedIn
                ? Optional.empty()
                : Optional.of("This browser is not signed in, or the studio was started by another user. Press Enter in"
                        + " the terminal in which RoboNewbie is running, and open the address that it prints.");
    }
}
