package org.robonewbie.app.command;

import org.robonewbie.programs.CalledWronglyException;

/**
 * Address of a server's monitor port.
 *
 * @param host host name or IP address
 * @param port TCP port, 1 to 65535
 */
record MonitorAddress(String host, int port) {

    private static final int DEFAULT_PORT = 3200;
    private static final int LAST_PORT = 65_535;

    /** Parses {@code HOST:PORT}, {@code HOST} or {@code :PORT}; the defaults are 127.0.0.1 and 3200. */
    static MonitorAddress of(String text) {
        int colon = text.lastIndexOf(':');
        String host = colon < 0 ? text : text.substring(0, colon);
        String port = colon < 0 ? "" : text.substring(colon + 1);
        return new MonitorAddress(
                host.isEmpty() ? "127.0.0.1" : host, port.isEmpty() ? DEFAULT_PORT : port(text, port));
    }

    private static int port(String text, String port) {
        try {
            int number = Integer.parseInt(port);
            if (number > 0 && number <= LAST_PORT) {
                return number;
            }
        } catch (NumberFormatException noNumber) {
            // reported below
        }
        throw new CalledWronglyException(
                "\"" + text + "\" is not a monitor address. Write HOST:PORT, such as 127.0.0.1:3200.");
    }
}
