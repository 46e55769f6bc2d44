#include "bench/bake_command.h"
#include "bench/render_command.h"
#include "bench/scene_command.h"
#include "bench/search_command.h"
#include "bench/shadow_command.h"
#include "bench/sheet_command.h"
#include "bench/solid_command.h"
#include "bench/sparkle_command.h"
#include "commands/program.h"

int main(int argc, char** argv) {
    CLI::App app("Measures map builders and search techniques.", "relievo-bench");
    app.require_subcommand(1);
    relievo::bench::BakeCommand bake(app);
    relievo::bench::RenderCommand render(app);
    relievo::bench::SceneCommand scene(app);
    relievo::bench::SearchCommand search(app);
    relievo::bench::ShadowCommand shadow(app);
    relievo::bench::SheetCommand sheet(app);
    relievo::bench::SolidCommand solid(app);
    relievo::bench::SparkleCommand sparkle(app);
    return relievo::commands::runProgram(app, argc, argv, [&] {
        if (bake.chosen())
            bake.run();
        if (render.chosen())
            render.run();
        if (scene.chosen())
            scene.run();
        if (search.chosen())
            search.run();
        if (shadow.chosen())
            shadow.run();
        if (sheet.chosen())
            sheet.run();
        if (solid.chosen())
            solid.run();
        if (sparkle.chosen())
            sparkle.run();
    });
}
