package org.robonewbie.simulator.server;

import org.robonewbie.protocol.frame.MessageBuffer;

/** A bounded FIFO queue of messages between two threads. It reuses its buffers. */
final class MessageQueue {

    private static final int CAPACITY = 64;

    private final MessageBuffer[] messages = new MessageBuffer[CAPACITY];
    private int first;
    private int count;
    private boolean closed;

    MessageQueue() {
        for (int i = 0; i < CAPACITY; i++) {
            messages[i] = new MessageBuffer();
        }
    }

    /** Appends a copy of a message; returns false if the queue is full or closed. */
    synchronized boolean offer(MessageBuffer message) {
        if (count == CAPACITY || closed) {
            return false;
        }
        append(message);
        return true;
    }

    /** Appends a copy of a message, blocking while the queue is full. Has no effect on a closed queue. */
    synchronized void put(MessageBuffer message) throws InterruptedException {
        while (count == CAPACITY && !closed) {
            wait();
        }
        if (!closed) {
            append(message);
        }
    }

    /** Removes the first message; returns false if the queue is empty. */
    synchronized boolean poll(MessageBuffer message) {
        if (count == 0) {
            return false;
        }
        message.clear();
        message.append(messages[first]);
        first = (first + 1) % CAPACITY;
        if (count-- == CAPACITY) {
            notifyAll();
        }
        return true;
    }

    /** Removes the first message, blocking while the queue is empty; returns false once it is empty and closed. */
    synchronized boolean take(MessageBuffer message) throws InterruptedException {
        while (count == 0 && !closed) {
            wait();
        }
        return poll(message);
    }

    /** Closes the queue for new messages; queued messages can still be removed. */
    synchronized void close() {
        closed = true;
        notifyAll();
    }

    synchronized boolean isClosed() {
        return closed;
    }

    /** Returns whether the queue is closed and empty. */
    synchronized boolean isExhausted() {
        return closed && count == 0;
    }

    private void append(MessageBuffer message) {
        MessageBuffer last = messages[(first + count) % CAPACITY];
        last.clear();
        last.append(message);
        if (count++ == 0) {
            notifyAll();
        }
    }
}
