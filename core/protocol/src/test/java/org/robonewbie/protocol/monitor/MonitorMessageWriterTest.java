package org.robonewbie.protocol.monitor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.monitor.MeshNode.StandardShape;
import org.robonewbie.protocol.order.PlayerNumber;

class MonitorMessageWriterTest {

    private static final Environment ENVIRONMENT = new Environment(
            List.of(new Environment.Measure("FieldLength", 30)),
            List.of("BeforeKickOff", "KickOff_Left", "KickOff_Right", "PlayOn"));
    private static final MonitoredGame START = state(0, 0, PlayMode.BEFORE_KICK_OFF);

    private final MeshNode box =
            new MeshNode(new StandardShape("StdUnitBox", List.of()), 1, 51, 1, List.of("matGrey"), false, true);
    private final TransformNode place = TransformNode.at(1, 2, 3, box);
    private final List<SceneNode> scene = List.of(place);
    private final MonitorMessageWriter writer = new MonitorMessageWriter(ENVIRONMENT);

    @Test
    void fullMessageTellsEverything() {
        assertThat(full(START))
                .isEqualTo("((FieldLength 30)(play_modes BeforeKickOff KickOff_Left KickOff_Right PlayOn)"
                        + "(time 0)(team_left red)(half 1)(score_left 0)(score_right 0)(play_mode 0))(RSG 0 1)"
                        + "((nd TRF (SLT 1 0 0 0 0 1 0 0 0 0 1 0 1 2 3 1)"
                        + "(nd SMN (setVisible 1) (load StdUnitBox) (sSc 1 51 1) (sMat matGrey))))");
    }

    @Test
    void firstListIsNeverEmpty() {
        full(START);

        assertThat(partial(START)).startsWith("((time 0))(RDS 0 1)(");
    }

    @Test
    void visibilityIsToldInTheFirstChangesAndWhenItChanges() {
        full(START);

        assertThat(partial(START)).endsWith("((nd(nd SMN (setVisible 1))))");
        assertThat(partial(START)).endsWith("((nd(nd SMN)))");
        box.setVisible(false);
        assertThat(partial(START)).endsWith("((nd(nd SMN (setVisible 0))))");
        assertThat(partial(START)).endsWith("((nd(nd SMN)))");
    }

    @Test
    void smallMovesAddUpUntilTheyAreTold() {
        full(START);
        partial(START);

        moveTo(1.004f);
        assertThat(partial(START)).endsWith("((nd(nd SMN)))");
        moveTo(1.0052f);
        assertThat(partial(START)).endsWith("((nd (SLT 1 0 0 0 0 1 0 0 0 0 1 0 1.0052 2 3 1)(nd SMN)))");
        moveTo(1.0101f);
        assertThat(partial(START)).endsWith("((nd(nd SMN)))");
    }

    @Test
    void onlyWhatHasChangedInTheMatchIsTold() {
        full(START);

        assertThat(partial(state(0.02, 0, PlayMode.PLAY_ON))).startsWith("((time 0.02)(play_mode 3))(");
        assertThat(partial(state(0.04, 0, PlayMode.PLAY_ON))).startsWith("((time 0.04))(");
        assertThat(partial(state(0.06, 1, PlayMode.PLAY_ON))).startsWith("((time 0.06)(score_left 1))(");
    }

    @Test
    void secondTeamIsToldOnceItIsKnown() {
        full(START);
        MonitoredGame both = new MonitoredGame(
                0, Optional.of("red"), Optional.of("blue"), 2, 0, 0, Optional.of(PlayMode.BEFORE_KICK_OFF), 0, 0);

        assertThat(partial(both)).startsWith("((time 0)(team_right blue)(half 2))(");
        assertThat(partial(both)).startsWith("((time 0))(");
    }

    @Test
    void waitAfterPassModeIsToldWhileItLasts() {
        full(START);
        MonitoredGame waiting = new MonitoredGame(
                5, Optional.of("red"), Optional.empty(), 1, 0, 0, Optional.of(PlayMode.BEFORE_KICK_OFF), 0, 9.5);

        assertThat(partial(waiting)).startsWith("((time 5)(pass_mode_score_wait_right 9.5))(");
        assertThat(partial(waiting)).startsWith("((time 5)(pass_mode_score_wait_right 9.5))(");
        assertThat(partial(START)).startsWith("((time 0))(");
    }

    @Test
    void eachFoulIsToldOnce() {
        full(START);
        Foul first = new Foul(1, FoulType.CHARGING, new PlayerNumber(TeamSide.RIGHT, 4));
        Foul second = new Foul(2, FoulType.CROWDING, new PlayerNumber(TeamSide.LEFT, 11));

        assertThat(partial(START, first)).startsWith("((time 0)(foul 1 6 2 4))(");
        assertThat(partial(START, first, second)).startsWith("((time 0)(foul 2 0 1 11))(");
        assertThat(partial(START, first, second)).startsWith("((time 0))(");
    }

    @Test
    void newcomersMessageDoesNotHideChangesFromTheOthers() {
        full(START);
        partial(START);
        moveTo(7);

        String newcomers = writer.writeFullForNewcomer(state(1, 1, PlayMode.PLAY_ON), scene)
                .toString();

        assertThat(newcomers).contains("(score_left 1)").contains("1 0 7 2 3 1)");
        assertThat(partial(state(1, 1, PlayMode.PLAY_ON)))
                .startsWith("((time 1)(score_left 1)(play_mode 3))")
                .contains("1 0 7 2 3 1)");
    }

    private void moveTo(float x) {
        place.moveTo(new float[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, 2, 3, 1}, 0);
    }

    private String full(MonitoredGame state) {
        return writer.writeFull(state, List.of(), scene).toString();
    }

    private String partial(MonitoredGame state, Foul... fouls) {
        return writer.writePartial(state, List.of(fouls), scene).toString();
    }

    private static MonitoredGame state(double time, int scoreLeft, PlayMode playMode) {
        return new MonitoredGame(
                time, Optional.of("red"), Optional.empty(), 1, scoreLeft, 0, Optional.of(playMode), 0, 0);
    }
}
