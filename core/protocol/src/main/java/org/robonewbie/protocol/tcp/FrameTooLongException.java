package org.robonewbie.protocol.tcp;

import java.io.IOException;

/** Thrown when the peer announces a message that is too long. The connection can no longer be used. */
public final class FrameTooLongException extends IOException {

    private static final long serialVersionUID = 1L;

    FrameTooLongException(long announcedBytes, int allowedBytes) {
        super("The other side announced a message of " + announcedBytes + " bytes, more than the " + allowedBytes
                + " bytes allowed. Does it use SimSpark's protocol, with a length of four bytes before each message?");
    }
}
