package org.robonewbie.studio.file;

/** Thrown when a page's request is refused; the message is shown to the user. */
public final class RefusedException extends RuntimeException {

    private static final long serialVersionUID = 1L;

    private final int status;

    /**
     * Creates the exception.
     *
     * @param status the HTTP status of the response
     * @param message what was refused and what to do
     */
    public RefusedException(int status, String message) {
        super(message);
        this.status = status;
    }

    /** {@return the HTTP status of the response} */
    public int status() {
        return status;
    }
}
