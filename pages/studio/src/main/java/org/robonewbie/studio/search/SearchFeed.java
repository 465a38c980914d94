package org.robonewbie.studio.search;

import com.google.gson.Gson;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.List;
import org.robonewbie.studio.board.EventBus;

/** Publishes the progress of an optimisation to all subscribed pages. Thread-safe. */
public final class SearchFeed extends EventBus {

    private final Gson gson = new Gson();
    private final JsonObject known = new JsonObject();
    private final JsonArray rounds = new JsonArray();

    /**
     * Creates a feed for a search that has not completed a round.
     *
     * @param task description of the optimisation
     */
    public SearchFeed(SearchTask task) {
        super("search", "optimise.html");
        known.addProperty("kind", "whole");
        known.add("task", gson.toJsonTree(task));
        known.add("rounds", rounds);
    }

    /**
     * Publishes the objective value of the initial parameters.
     *
     * @param value the value, in the unit of the objective
     */
    public synchronized void begins(double value) {
        known.addProperty("before", value);
        publishAll();
    }

    /**
     * Publishes the result of a round.
     *
     * @param round the round
     * @param numbers current values of the parameters
     * @param place page that shows the current result, such as {@code #motion/kick-so-far}; may be empty
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
        publish(news.toString());
    }

    /**
     * Publishes the final result.
     *
     * @param value objective value of the result
     * @param words the outcome, as a sentence
     * @param place page that shows the result, as for {@link #reached}
     */
    public synchronized void ends(double value, String words, String place) {
        known.addProperty("after", value);
        known.addProperty("outcome", words);
        known.addProperty("place", place);
        publishAll();
    }

    @Override
    protected String known() {
        return known.toString();
    }
}
