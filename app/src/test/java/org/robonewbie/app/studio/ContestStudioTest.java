package org.robonewbie.app.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.URI;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.app.BoardPage;
import org.robonewbie.competition.Competition;
import org.robonewbie.competition.CompetitionSettings;
import org.robonewbie.competition.contest.Conditions;
import org.robonewbie.competition.contest.Contest;
import org.robonewbie.competition.contest.Contests;
import org.robonewbie.competition.team.TeamEntry;
import org.robonewbie.competition.team.TeamList;
import org.robonewbie.programs.ExampleCatalogue;
import org.robonewbie.programs.process.Limits;
import org.robonewbie.programs.process.Sandbox;

/** Updates of the wall during a contest. */
class ContestStudioTest {

    @TempDir
    Path folder = Path.of("");

    @Test
    void wallShowsTrialsWhileTheyRunAndTheTableAsItGrows() throws Exception {
        List<TeamEntry> teams = TeamList.parse(List.of("Red=Agent_Wave", "Blue=Agent_Wave"));
        Contest contest = Contests.scoring(Conditions.of(1), 1);
        try (ContestStudio studio = ContestStudio.open(contest, folder);
                BoardPage page = new BoardPage(URI.create(studio.invitation()), "wall")) {
            CompetitionSettings settings = new CompetitionSettings(
                    1,
                    folder,
                    Path.of(""),
                    ExampleCatalogue.classNames(),
                    2,
                    Limits.DEFAULT,
                    Sandbox.none("not wanted"),
                    studio);

            new Competition(contest, teams, settings, System.out).hold();

            assertThat(page.next("\"over\":0")).contains("\"title\":\"Scoring\"", "\"planned\":2");
            assertThat(page.next("\"studio\":\"http://127.0.0.1:")).contains("\"length\":12");
            assertThat(page.next("\"robots\":[{\"side\":\"left\"")).contains("\"kind\":\"moments\"", "\"ball\":[");
            assertThat(page.next("\"over\":2")).contains("played to the end", "\"id\":\"scoring-Red\"");
        }
    }
}
