package org.robonewbie.studio;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.HttpURLConnection;
import java.net.Proxy;
import java.net.URI;

/** Obtains the cookie of a studio as a browser does, in exchange for a one-time code. */
public final class StudioCookie {

    private StudioCookie() {}

    /**
     * Opens a one-time address.
     *
     * @param oneTimeAddress an address with a code
     * @return the value of the Cookie header
     */
    public static String of(URI oneTimeAddress) {
        try {
            HttpURLConnection visit = (HttpURLConnection) oneTimeAddress.toURL().openConnection(Proxy.NO_PROXY);
            visit.setInstanceFollowRedirects(false);
            String cookie = visit.getHeaderField("Set-Cookie");
            if (cookie == null) {
                throw new AssertionError("The studio answers " + visit.getResponseCode() + " to its own address.");
            }
            return cookie.substring(0, cookie.indexOf(';'));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
