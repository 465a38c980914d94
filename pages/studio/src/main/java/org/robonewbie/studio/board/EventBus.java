package org.robonewbie.studio.board;

import java.net.URI;
import java.util.LinkedHashSet;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;

/**
 * Publishes the progress of a program to all subscribed pages. A new page receives the whole state first, then the updates.
 * Thread-safe.
 */
public abstract class EventBus {

    /** Prefix of the WebSocket paths of all buses. */
    public static final String PATHS = "/live-";

    private static final long RELOADING_MILLIS = 2000;

    private final String path;
    private final String page;
    private final Set<BoardReader> readers = new LinkedHashSet<>();

    /**
     * Creates a bus without subscribers.
     *
     * @param name one word, appended to {@link #PATHS}
     * @param page file name of its HTML page
     */
    protected EventBus(String name, String page) {
        this.path = PATHS + name;
        this.page = page;
    }

    /** {@return the WebSocket path} */
    public final String path() {
        return path;
    }

    /**
     * Returns the address of the page.
     *
     * @param studio address of the studio, with or without a sign-in code
     * @return address of the page, with the sign-in code if there is one
     */
    public final URI page(URI studio) {
        String query = studio.getRawQuery();
        return studio.resolve(query == null ? page : page + "?" + query);
    }

    /** {@return whether a page is open} */
    public final synchronized boolean isWatched() {
        return !readers.isEmpty();
    }

    /**
     * Waits until a page is open.
     *
     * @param milliseconds maximum time to wait
     * @throws InterruptedException if this thread is interrupted
     */
    public final synchronized void awaitWatched(long milliseconds) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(milliseconds);
        for (long rest = milliseconds; rest > 0 && !isWatched(); ) {
            wait(rest);
            rest = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
        }
    }

    /**
     * Waits until no page is open. A page that is being reloaded counts as open.
     *
     * @param elsewhere returns whether another page of the same studio is open
     * @throws InterruptedException if this thread is interrupted
     */
    public final synchronized void awaitUnwatched(BooleanSupplier elsewhere) throws InterruptedException {
        boolean watched = isWatched();
        while (watched) {
            wait(RELOADING_MILLIS);
            watched = isWatched() || elsewhere.getAsBoolean();
        }
    }

    /**
     * Returns the whole state, for a page that is new or has missed updates. Called with this bus locked.
     *
     * @return one JSON object
     */
    protected abstract String known();

    /** Publishes the whole state. */
    protected final synchronized void publishAll() {
        publish(known());
    }

    /**
     * Publishes an update.
     *
     * @param json one JSON object
     */
    protected final synchronized void publish(String json) {
        readers.forEach(reader -> reader.offer(json));
    }

    synchronized void add(BoardReader reader) {
        readers.add(reader);
        notifyAll();
        reader.offer(known());
    }

    synchronized void remove(BoardReader reader) {
        readers.remove(reader);
    }

    /** Sends the whole state to a page that has missed updates. */
    synchronized void resend(BoardReader reader) {
        reader.offer(known());
    }
}
