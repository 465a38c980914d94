package org.robonewbie.simulator.server;

import org.robonewbie.protocol.frame.MessageBuffer;

/** Messages on their way from one thread to another, in order; the buffers are used again and again. */
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

    /** Appends a copy of a message unless the queue is full or closed; returns whether it did. */
    synchronized boolean offer(MessageBuffer message) {
        if (count == CAPACITY || closed) {
            return false;
        }
        append(message);
        return true;
    }

    /** Appends a copy of a message as soon as there is room; does nothing once the queue is closed. */
    synchronized void put(MessageBuffer message) throws InterruptedException {
        while (count == CAPACITY && !closed) {
            wait();
        }
        if (!closed) {
            append(message);
        }
    }

    /** Takes the first message; false if there is none. */
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

    /** Waits for the first message and takes it; false if the queue is empty and closed. */
    synchronized boolean take(MessageBuffer message) throws InterruptedException {
        while (count == 0 && !closed) {
            wait();
        }
        return poll(message);
    }

    /** Accepts no more messages; those inside can still be taken. */
    synchronized void close() {
        closed = true;
        notifyAll();
    }

    synchronized boolean isClosed() {
        return closed;
    }

    /** Whether the queue is empty and no more messages can come. */
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
