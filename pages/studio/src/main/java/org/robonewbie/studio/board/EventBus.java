package org.robonewbie.studio.board;

import java.net.URI;
import java.util.LinkedHashSet;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;

/**
 * Where a program reports its progress to all pages that watch it: each page receives everything known so far, and then what
 * is new. Thread-safe.
 */
public abstract class EventBus {

    /** With what the addresses begin at which pages listen. */
    public static final String PATHS = "/live-";

    private static final long RELOADING_MILLIS = 2000;

    private final String path;
    private final String page;
    private final Set<BoardReader> readers = new LinkedHashSet<>();

    /**
     * Creates a board that nobody reads yet.
     *
     * @param name one word, after which the address is named at which pages listen
     * @param page the file of its page
     */
    protected EventBus(String name, String page) {
        this.path = PATHS + name;
        this.page = page;
    }

    /** {@return where pages listen} */
    public final String path() {
        return path;
    }

    /**
     * Returns the address of the board.
     *
     * @param studio the address of the studio that shows it
     * @return the address of the page, with the code that the studio's address holds, if it holds one
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
     * @param milliseconds how long at most
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
     * Waits until no page is open any more; a page may be reloaded meanwhile.
     *
     * @param elsewhere whether another page of the same studio is open
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
     * Writes down everything known, for a page that has just been opened or has missed something; called with this board locked.
     *
     * @return one JSON object
     */
    protected abstract String known();

    /** Sends everything known to all pages. */
    protected final synchronized void tellWhole() {
        tell(known());
    }

    /**
     * Sends news to all pages.
     *
     * @param json one JSON object
     */
    protected final synchronized void tell(String json) {
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

    /** Sends everything to a page that has missed something. */
    synchronized void tellAgain(BoardReader reader) {
        reader.offer(known());
    }
}
