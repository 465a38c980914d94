package org.robonewbie.studio.search;

import com.google.gson.Gson;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.List;
import org.robonewbie.studio.board.EventBus;

/** Where a search reports its progress to all pages that watch it. Thread-safe. */
public final class SearchFeed extends EventBus {

    private final Gson gson = new Gson();
    private final JsonObject known = new JsonObject();
    private final JsonArray rounds = new JsonArray();

    /**
     * Creates an empty board.
     *
     * @param task the task of the search
     */
    public SearchFeed(SearchTask task) {
        super("search", "optimise.html");
        known.addProperty("kind", "whole");
        known.add("task", gson.toJsonTree(task));
        known.add("rounds", rounds);
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

    @Override
    protected String known() {
        return known.toString();
    }
}
