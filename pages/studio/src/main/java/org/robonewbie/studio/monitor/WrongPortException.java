package org.robonewbie.studio.monitor;

import java.io.IOException;

/** Thrown when a port turns out to be none for monitors. The message says which server it belongs to and what to do. */
public final class WrongPortException extends IOException {

    private static final long serialVersionUID = 1;

    WrongPortException(String message) {
        super(message);
    }
}
