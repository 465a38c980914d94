package org.robonewbie.studio;

import com.google.gson.Gson;
import com.google.gson.JsonObject;
import java.net.URI;
import java.util.List;
import java.util.function.IntFunction;
import org.robonewbie.studio.wall.TrialWall;
import org.robonewbie.studio.wall.WallTable;

/** The wall of a contest whose trials are the worlds of other studios; a test reports the results. */
final class StagedWall implements AutoCloseable {

    private final TrialWall wall = new TrialWall("Scoring", "The earliest goal wins.");

    TrialWall wall() {
        return wall;
    }

    /** Publishes news: a trial that begins or ends, its result, the table, or the end of the contest. */
    void tell(JsonObject news, IntFunction<TestSimulator> simulations) {
        if (news.has("begins")) {
            wall.begins(
                    news.get("begins").getAsString(),
                    List.of(news.get("team").getAsString()),
                    simulations.apply(news.get("in").getAsInt()).control(),
                    URI.create(news.get("at").getAsString()));
        }
        if (news.has("ends")) {
            wall.ends(news.get("ends").getAsString());
        }
        if (news.has("result")) {
            wall.result(news.get("of").getAsString(), news.get("result").getAsString());
        }
        if (news.has("table")) {
            wall.stands(new Gson().fromJson(news.get("table"), WallTable.class));
        }
        if (news.has("outcome")) {
            wall.isOver(news.get("outcome").getAsString());
        }
    }

    @Override
    public void close() {
        wall.close();
    }
}
