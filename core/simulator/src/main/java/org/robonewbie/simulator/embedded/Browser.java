package org.robonewbie.simulator.embedded;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.robonewbie.simulator.Console;

/**
 * Opens the user's browser with the operating system's command. The command contains a {@link RedirectPage} instead of
 * the address, because command lines are visible to all users of a computer.
 */
public final class Browser {

    private static final long RECONNECT_MILLISECONDS = 1200;
    private static final long POLL_MILLISECONDS = 50;

    private Browser() {}

    /**
     * Opens a view in the browser, unless a page that is still open from an earlier run reconnects. Non-blocking.
     *
     * @param view the view
     * @param console receives the address if the browser cannot be opened
     */
    public static void openUnlessWatched(Viewer.View view, Console console) {
        Thread opener = new Thread(
                () -> {
                    if (!reconnects(view)) {
                        open(view.oneTimeAddress(), console);
                    }
                },
                "browser-opener");
        opener.setDaemon(true);
        opener.start();
    }

    private static boolean reconnects(Viewer.View view) {
        for (long waited = 0; waited < RECONNECT_MILLISECONDS && !view.isWatched(); waited += POLL_MILLISECONDS) {
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(POLL_MILLISECONDS));
        }
        return view.isWatched();
    }

    /**
     * Opens an address in the browser.
     *
     * @param address the address, which must stay secret from other users of this computer
     * @param console receives the address if the browser cannot be opened
     */
    public static void open(URI address, Console console) {
        try {
            new ProcessBuilder(command(System.getProperty("os.name", ""), RedirectPage.write(address)))
                    .redirectErrorStream(true)
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start();
        } catch (IOException e) {
            console.say("The browser could not be started. Open " + address + " manually.");
        }
    }

    static List<String> command(String operatingSystem, Path page) {
        String system = operatingSystem.toLowerCase(Locale.ROOT);
        if (system.contains("win")) {
            return List.of("rundll32", "url.dll,FileProtocolHandler", page.toString());
        }
        return List.of(system.contains("mac") ? "open" : "xdg-open", page.toString());
    }
}
