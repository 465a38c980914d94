package org.robonewbie.studio;

import com.google.gson.Gson;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.util.List;
import java.util.Map;
import org.robonewbie.studio.search.SearchFeed;
import org.robonewbie.studio.search.SearchNumber;
import org.robonewbie.studio.search.SearchRound;
import org.robonewbie.studio.search.SearchTask;

/** An optimisation whose progress a test reports. */
final class StagedSearch {

    private final Gson gson = new Gson();
    private final SearchFeed feed;

    /** Takes the task as a JSON object. */
    StagedSearch(JsonElement task) {
        feed = new SearchFeed(gson.fromJson(task, SearchTask.class));
    }

    SearchFeed feed() {
        return feed;
    }

    /** Publishes news, if there are any, and returns whether a page shows them. */
    Map<String, Object> answer(JsonObject news) {
        if (news.has("begins")) {
            feed.begins(news.get("begins").getAsDouble());
        } else if (news.has("round")) {
            feed.reached(
                    gson.fromJson(news.get("round"), SearchRound.class),
                    List.of(gson.fromJson(news.get("numbers"), SearchNumber[].class)),
                    news.get("place").getAsString());
        } else if (news.has("ends")) {
            feed.ends(
                    news.get("ends").getAsDouble(),
                    news.get("outcome").getAsString(),
                    news.get("place").getAsString());
        } else if (news.has("awaitUnwatched")) {
            awaitUnwatched();
        }
        return Map.of("isWatched", feed.isWatched());
    }

    private void awaitUnwatched() {
        try {
            feed.awaitUnwatched(() -> false);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }
}
