package org.robonewbie.web.library.org.slf4j;

import org.slf4j.Logger;
import org.slf4j.helpers.NOPLogger;

/** What ode4j needs of {@link org.slf4j.LoggerFactory}: in a page nobody reads its diary. */
public final class LoggerFactory {

    private LoggerFactory() {}

    /**
     * Finds a logger.
     *
     * @param name any
     * @return the logger that writes nothing
     */
    public static Logger getLogger(String name) {
        return NOPLogger.NOP_LOGGER;
    }

    /**
     * Finds a logger.
     *
     * @param type any
     * @return the logger that writes nothing
     */
    public static Logger getLogger(Class<?> type) {
        return NOPLogger.NOP_LOGGER;
    }
}
