package org.robonewbie.studio.search;

import com.google.gson.Gson;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.net.URI;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.BooleanSupplier;

/**
 * Where a search reports its progress to all pages that watch it: each page receives everything written so far, and then what
 * is new. Thread-safe.
 */
public final class SearchBoard {

    /** Where pages listen. */
    public static final String PATH = "/live-search";

    private static final long RELOADING_MILLIS = 2000;
    private static final String PAGE = "optimise.html?";

    private final Gson gson = new Gson();
    private final JsonObject known = new JsonObject();
    private final JsonArray rounds = new JsonArray();
    private final Set<SearchSpectator> spectators = new LinkedHashSet<>();

    /**
     * Creates an empty board.
     *
     * @param task the task of the search
     */
    public SearchBoard(SearchTask task) {
        known.addProperty("kind", "whole");
        known.add("task", gson.toJsonTree(task));
        known.add("rounds", rounds);
    }

    /**
     * Returns the address of the board.
     *
     * @param studio the address of the studio that shows it
     * @return the address of the page, with its token
     */
    public static URI page(URI studio) {
        return studio.resolve(PAGE + studio.getRawQuery());
    }

    /**
     * Writes down how well the start does.
     *
     * @param value in the unit of the objective
     */
    public synchronized void begins(double value) {
        known.addProperty("before", value);
        tellWhole();
    }

    /**
     * Writes down what a round has reached.
     *
     * @param round the round
     * @param numbers where the search is now
     * @param place what shows the present state of the search, such as {@code #motion/kick-so-far}; empty for nothing
     */
    public synchronized void reached(SearchRound round, List<SearchNumber> numbers, String place) {
        JsonObject news = new JsonObject();
        news.addProperty("kind", "round");
        news.add("round", gson.toJsonTree(round));
        rounds.add(news.get("round"));
        news.add("numbers", gson.toJsonTree(numbers));
        known.add("numbers", news.get("numbers"));
        news.addProperty("place", place);
        known.addProperty("place", place);
        tell(news.toString());
    }

    /**
     * Writes down what came out.
     *
     * @param value of the result, in the unit of the objective
     * @param words the outcome in a sentence
     * @param place what shows the result, as for {@link #reached}
     */
    public synchronized void ends(double value, String words, String place) {
        known.addProperty("after", value);
        known.addProperty("outcome", words);
        known.addProperty("place", place);
        tellWhole();
    }

    /** {@return whether a page is open} */
    public synchronized boolean isWatched() {
        return !spectators.isEmpty();
    }

    /**
     * Waits until no page is open any more; a page may be reloaded meanwhile.
     *
     * @param elsewhere whether another page of the same studio is open
     * @throws InterruptedException if this thread is interrupted
     */
    public synchronized void awaitUnwatched(BooleanSupplier elsewhere) throws InterruptedException {
        boolean watched = isWatched();
        while (watched) {
            wait(RELOADING_MILLIS);
            watched = isWatched() || elsewhere.getAsBoolean();
        }
    }

    synchronized void add(SearchSpectator spectator) {
        spectators.add(spectator);
        spectator.offer(known.toString());
    }

    synchronized void remove(SearchSpectator spectator) {
        spectators.remove(spectator);
    }

    /** Sends everything to a page that has missed something. */
    synchronized void tellAgain(SearchSpectator spectator) {
        spectator.offer(known.toString());
    }

    private void tellWhole() {
        tell(known.toString());
    }

    private void tell(String json) {
        spectators.forEach(spectator -> spectator.offer(json));
    }
}
