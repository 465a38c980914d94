package org.robonewbie.web.library.org.slf4j;

import org.slf4j.Logger;
import org.slf4j.helpers.NOPLogger;

/** Subset of {@link org.slf4j.LoggerFactory} for ode4j: logging is disabled in a page. */
public final class LoggerFactory {

    private LoggerFactory() {}

    /**
     * Returns a logger.
     *
     * @param name ignored
     * @return a logger that discards all messages
     */
    public static Logger getLogger(String name) {
        return NOPLogger.NOP_LOGGER;
    }

    /**
     * Returns a logger.
     *
     * @param type ignored
     * @return a logger that discards all messages
     */
    public static Logger getLogger(Class<?> type) {
        return NOPLogger.NOP_LOGGER;
    }
}
