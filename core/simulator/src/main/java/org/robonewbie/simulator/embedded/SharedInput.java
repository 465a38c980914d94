package org.robonewbie.simulator.embedded;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InterruptedIOException;

/**
 * Standard input for a program that shares the terminal with the simulator. The program receives the bytes offered after
 * its first read.
 */
final class SharedInput extends InputStream {

    private ByteArrayInputStream pending = new ByteArrayInputStream(new byte[0]);
    private boolean isRead;
    private boolean isClosed;

    /** Offers bytes to the program; returns false if it has not started reading. */
    synchronized boolean offer(byte[] bytes) {
        if (isRead) {
            ByteArrayOutputStream all = new ByteArrayOutputStream();
            all.writeBytes(pending.readAllBytes());
            all.writeBytes(bytes);
            pending = new ByteArrayInputStream(all.toByteArray());
            notifyAll();
        }
        return isRead;
    }

    @Override
    public int read() throws IOException {
        byte[] one = new byte[1];
        return read(one, 0, 1) < 0 ? -1 : one[0] & 0xff;
    }

    @Override
    public synchronized int read(byte[] bytes, int offset, int length) throws IOException {
        isRead = true;
        if (length == 0) {
            return 0;
        }
        try {
            while (pending.available() == 0 && !isClosed) {
                wait();
            }
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
            throw (IOException)
                    new InterruptedIOException("The program was interrupted while reading.").initCause(stop);
        }
        return pending.read(bytes, offset, length);
    }

    @Override
    public synchronized int available() {
        return pending.available();
    }

    @Override
    public synchronized void close() {
        isClosed = true;
        notifyAll();
    }
}
