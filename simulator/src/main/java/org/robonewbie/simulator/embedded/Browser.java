package org.robonewbie.simulator.embedded;

import java.io.IOException;
import java.net.URI;
import java.util.List;
import java.util.Locale;
import org.robonewbie.simulator.server.Console;

/** Opens the user's browser with the command of the operating system; where that fails, people open it themselves. */
final class Browser {

    private Browser() {}

    static void open(URI address, Console console) {
        try {
            new ProcessBuilder(command(System.getProperty("os.name", ""), address))
                    .redirectErrorStream(true)
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start();
        } catch (IOException e) {
            console.say("The browser could not be opened. Open " + address + " yourself.");
        }
    }

    static List<String> command(String operatingSystem, URI address) {
        String system = operatingSystem.toLowerCase(Locale.ROOT);
        if (system.contains("win")) {
            return List.of("rundll32", "url.dll,FileProtocolHandler", address.toString());
        }
        return List.of(system.contains("mac") ? "open" : "xdg-open", address.toString());
    }
}
