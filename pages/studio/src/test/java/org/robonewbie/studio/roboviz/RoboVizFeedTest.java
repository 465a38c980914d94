package org.robonewbie.studio.roboviz;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.TeamSide;

class RoboVizFeedTest {

    private final RoboVizFeed board = new RoboVizFeed();

    private void draw(String set, double x) {
        board.execute(List.of(new RoboVizCommand.Draw(set, "point", List.of(x, 0.0, 0.0, 5.0), "#ff0000", 1, "")));
    }

    private void swap(String prefix) {
        board.execute(List.of(new RoboVizCommand.Swap(prefix)));
    }

    @Test
    void shapesAppearAtTheNextSwapOfTheirSet() {
        draw("Stars.path", 3);
        assertThat(board.since(0)).isEmpty();

        swap("Stars");

        assertThat(board.since(0))
                .hasValueSatisfying(json -> assertThat(json)
                        .contains("\"Stars.path\":[{\"shape\":\"point\",\"numbers\":[3.0,0.0,0.0,5.0]"));
        assertThat(board.since(board.revision())).isEmpty();
    }

    @Test
    void swapWithoutShapesErasesAndLeavesOtherSetsAlone() {
        draw("Stars.path", 3);
        draw("Moons.path", 4);
        swap("");
        int before = board.revision();

        swap("Stars");

        assertThat(board.since(before)).hasValue("{\"kind\":\"board\",\"sets\":{\"Stars.path\":[]}}");
    }

    @Test
    void textAboveARobotNeedsNoSwap() {
        board.execute(List.of(new RoboVizCommand.AgentText(TeamSide.RIGHT, 7, "#ffffff", "attack")));
        assertThat(board.since(0))
                .hasValueSatisfying(json -> assertThat(json)
                        .contains("\"side\":\"right\",\"number\":7")
                        .contains("attack"));
        int before = board.revision();

        board.execute(List.of(new RoboVizCommand.AgentText(TeamSide.RIGHT, 7, "#ffffff", "")));

        assertThat(board.since(before))
                .hasValueSatisfying(json -> assertThat(json).doesNotContain("attack"));
    }

    @Test
    void floodOfShapesAndSetsIsBounded() {
        for (int i = 0; i < 3000; i++) {
            draw("one", i);
            draw("set " + i, 0);
        }
        swap("");

        String json = board.since(0).orElseThrow();
        assertThat(json.split("\"shape\"")).hasSizeLessThan(2_400);
    }
}
