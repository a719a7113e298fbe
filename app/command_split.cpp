// SPDX-License-Identifier: MIT
#include "app/bench/variants.h"
#include "app/commands.h"
#include "app/common_options.h"
#include "app/contact_sheet.h"
#include "app/frame_run.h"
#include "app/output_files.h"
#include "app/progress.h"
#include "app/scene_files.h"
#include "app/scene_options.h"
#include "app/settings_options.h"
#include "app/split/chain.h"
#include "app/split/split_picture.h"
#include "app/split/split_report.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/memory.h"
#include "renderer/gl/capabilities.h"
#include "renderer/image/image_io.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace romascope {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMostVariants = 4096;

struct SplitOptions {
    std::vector<std::string> scenes; ///< none: those that come with the program
    std::vector<std::string> variations;
    std::vector<std::string> best;
    fs::path csv, json, picture;
    SettingsOptions settings;
    SceneOptions memory;
    BackendOptions backend;
};

/// What is asked unless it is said otherwise: every tracer, few pixels of many cameras.
Settings split_settings(const SplitOptions& options) {
    Settings settings(all_knobs());
    settings.set(kTracer, "");
    settings.set(kWidth, 64);
    settings.set(kHeight, 36);
    settings.set(kFrames, 16);
    settings = options.settings.apply_to(settings);
    check_one_moment(settings);
    check_technique(settings, options.settings.technique);
    return settings;
}

std::vector<BenchVariant> variants_of(const SplitOptions& options, const Settings& settings) {
    if (!options.variations.empty())
        return expand_variants(settings, parse_variations(settings, options.variations),
                               kMostVariants);
    std::vector<Variation> variations = default_variations(settings, options.settings);
    std::erase_if(variations, [](const Variation& variation) {
        return variation.knob->key() == "dda2d.hierarchy"; // it changes no hit
    });
    return expand_variants(settings, variations);
}

std::vector<const KnobBase*> best_keys(const SplitOptions& options, const Settings& settings) {
    std::vector<const KnobBase*> keys;
    for (const std::string& key : options.best)
        keys.push_back(&settings.table().at(key));
    return keys;
}

std::vector<Camera> cameras_of(const Scene& scene, const Settings& settings, const Pose& pose) {
    if (!settings.get(kCamera).empty())
        return {chosen_camera(scene, settings, pose)};
    std::vector<Camera> cameras;
    for (size_t i = 0; i < scene.cameras.size(); ++i)
        cameras.push_back(camera_at(scene, i, pose));
    return cameras;
}

std::vector<std::unique_ptr<SplitScene>> load_scenes(const SplitOptions& options,
                                                     const std::vector<fs::path>& files,
                                                     const std::vector<BenchVariant>& variants) {
    const Settings& settings = variants.front().settings;
    const bool software = query_driver().software;
    std::vector<std::unique_ptr<SplitScene>> scenes;
    for (const fs::path& file : files) {
        Scene scene = options.memory.load(file);
        if (software)
            for (const BenchVariant& variant : variants)
                check_memory(scene, variant.settings, options.memory.left_beside(scene),
                             options.memory.max_memory.has_value());
        for (const std::string& notice : notices_of(variants, scene))
            tell_notice(file, notice);
        const Pose pose = pose_of_frame(scene, settings, 0);
        std::vector<Camera> cameras = cameras_of(scene, settings, pose);
        scenes.push_back(
            std::make_unique<SplitScene>(std::move(scene), pose, std::move(cameras),
                                         glm::ivec2(settings.get(kWidth), settings.get(kHeight))));
    }
    return scenes;
}

/// A scene that is named twice is asked once, or it would count twice in the sum.
std::vector<fs::path> each_once(const std::vector<fs::path>& files) {
    std::vector<fs::path> once;
    for (const fs::path& file : files) {
        const auto is_same = [&](const fs::path& other) {
            std::error_code code;
            return fs::equivalent(file, other, code);
        };
        if (std::ranges::none_of(once, is_same))
            once.push_back(file);
    }
    return once;
}

/// The pictures of all variants, scenes and cameras in one.
class Sheet {
public:
    Sheet(const std::vector<std::unique_ptr<SplitScene>>& scenes, size_t variants, glm::ivec2 size,
          size_t memory)
        : size_(size) {
        size_t rows = 0;
        for (const auto& scene : scenes)
            rows += variants * scene->cameras().size();
        const glm::ivec2 tile = SplitPictures::magnification(size) * size;
        const size_t needed =
            ContactSheet::bytes_needed(rows, 1, tile.x, tile.y, kSplitCaptions.size());
        if (needed > memory)
            throw Error(fmt::format("--picture: {} rows of pictures need {}: choose a smaller "
                                    "--size, or fewer scenes or variants",
                                    rows, format_bytes(needed)),
                        kBadInput);
        sheet_.emplace(rows, 1, tile.x, tile.y, kSplitCaptions);
    }
    void add(const std::string& variant, const SplitScene& scene, const SplitPictures& pictures) {
        for (size_t camera = 0; camera < scene.cameras().size(); ++camera)
            sheet_->add(
                fmt::format("{}, {}: {}", scene.name(), scene.cameras()[camera].name, variant),
                pictures.of(camera));
    }
    glm::ivec2 size() const { return size_; }
    const Image& picture() const { return sheet_->picture(); }

private:
    glm::ivec2 size_;
    std::optional<ContactSheet> sheet_;
};

std::vector<SplitResult> run(std::vector<std::unique_ptr<SplitScene>>& scenes,
                             const std::vector<BenchVariant>& variants, Sheet* sheet) {
    const int frames = variants.front().settings.get(kFrames);
    Progress progress("asked");
    const double all = static_cast<double>(variants.size() * scenes.size()) * frames;
    int done = 0;
    Chain chain;
    std::vector<SplitResult> results;
    for (const BenchVariant& variant : variants) {
        SplitResult& result = results.emplace_back(SplitResult{variant.name, {}});
        for (const auto& scene : scenes) {
            Tally& tally = result.scenes.emplace_back();
            std::optional<SplitPictures> pictures;
            if (sheet)
                pictures.emplace(*scene, sheet->size());
            for (int frame = 0; frame < frames; ++frame) {
                const std::vector<ChainAnswers> answers =
                    chain.ask(*scene, variant.settings, static_cast<uint32_t>(frame));
                for (const ChainAnswers& ray : answers)
                    tally.add(ray);
                if (pictures)
                    pictures->add(answers);
                progress.done(++done / all);
            }
            if (sheet)
                sheet->add(variant.name, *scene, *pictures);
        }
    }
    return results;
}

/// Of each group of variants that agree in these settings the one with the fewest wrong rays.
std::vector<SplitResult> best_of(const std::vector<SplitResult>& results,
                                 const std::vector<BenchVariant>& variants,
                                 const std::vector<const KnobBase*>& keys) {
    std::vector<SplitResult> best;
    std::vector<std::vector<std::string>> groups;
    for (size_t i = 0; i < results.size(); ++i) {
        const std::string tracer = variants[i].settings.get(kTracer);
        std::vector<std::string> group = {tracer};
        for (const KnobBase* key : keys)
            if (!is_of_other_tracer(*key, tracer))
                group.push_back(to_text(variants[i].settings.value(*key)));
        const auto found = std::ranges::find(groups, group);
        if (found == groups.end()) {
            groups.push_back(group);
            best.push_back(results[i]);
            continue;
        }
        SplitResult& so_far = best[static_cast<size_t>(found - groups.begin())];
        const auto wrong = [](const SplitResult& result) {
            return result.all().of(Step::own_direction).wrong();
        };
        if (wrong(results[i]) < wrong(so_far))
            so_far = results[i];
    }
    return best;
}

/// Nothing that changes from run to run.
Facts facts_of(const std::vector<std::unique_ptr<SplitScene>>& scenes, const Settings& settings) {
    const DriverFacts driver = query_driver();
    Facts facts = {{"program", program_fact()},
                   {"machine", processor_fact()},
                   {"renderer", driver.renderer},
                   {"driver", driver.version}};
    for (const auto& scene : scenes) {
        std::vector<std::string> cameras;
        for (const Camera& camera : scene->cameras())
            cameras.push_back(camera.name);
        facts.emplace_back("scene", fmt::format("{}, {} triangles, cameras: {}", scene->name(),
                                                scene->triangles(), fmt::join(cameras, ", ")));
    }
    facts.emplace_back("rays", fmt::format("one for each surface point in {}x{} pixels and each of "
                                           "{} frames, seed {}",
                                           settings.get(kWidth), settings.get(kHeight),
                                           settings.get(kFrames), settings.get(kSeed)));
    facts.emplace_back("settings", settings_fact(settings));
    return facts;
}

int split(const SplitOptions& options) {
    const Settings settings = split_settings(options);
    const std::vector<BenchVariant> variants = variants_of(options, settings);
    const std::vector<const KnobBase*> keys = best_keys(options, settings);
    if (!options.picture.empty())
        check_image_extension(options.picture);
    std::vector<std::string> words = options.scenes;
    if (words.empty())
        for (const BuiltInScene& scene : built_in_scenes())
            words.push_back(scene.name);
    const std::vector<fs::path> files = each_once(find_scenes(words));
    std::vector<fs::path> inputs = options.settings.configs;
    inputs.insert(inputs.end(), files.begin(), files.end());
    check_output_files({options.csv, options.json, options.picture}, inputs);

    const std::unique_ptr<Context> context = options.backend.make_context();
    std::vector<std::unique_ptr<SplitScene>> scenes = load_scenes(options, files, variants);
    std::optional<Sheet> sheet;
    if (!options.picture.empty())
        sheet.emplace(scenes, variants.size(),
                      glm::ivec2(settings.get(kWidth), settings.get(kHeight)),
                      options.memory.limit());
    std::vector<SplitResult> results = run(scenes, variants, sheet ? &*sheet : nullptr);
    if (!options.best.empty())
        results = best_of(results, variants, keys);

    const Facts facts = facts_of(scenes, settings);
    std::vector<std::string> names;
    for (const auto& scene : scenes)
        names.push_back(scene->name());
    if (!options.csv.empty())
        write_file_atomically(options.csv, split_csv(facts, names, results));
    if (!options.json.empty())
        write_file_atomically(options.json, split_json(facts, names, results));
    if (sheet)
        write_image(options.picture, sheet->picture());
    fmt::print("{}", split_table(facts, names, results));
    return 0;
}

} // namespace

Command add_split_command(CLI::App& app) {
    auto options = std::make_shared<SplitOptions>();
    CLI::App* command = app.add_subcommand(
        "split", "Where rays go wrong: errors by voxelisation, by snapping and by resampling");
    command
        ->add_option("SCENE", options->scenes,
                     "files, folders or built-in scenes by name; none: all built-in scenes")
        ->type_name("");
    command
        ->add_option("--vary", options->variations,
                     "ask about each of these values of a setting, technique.tracer among them; "
                     "may be repeated")
        ->type_name("KEY=A,B,C")
        ->allow_extra_args(false);
    command
        ->add_option("--best", options->best,
                     "tell only the variant with the fewest wrong rays, for each tracer and each "
                     "value of these settings")
        ->type_name("KEY,KEY")
        ->delimiter(',')
        ->allow_extra_args(false);
    options->settings.add_to(*command, "pixels whose surfaces rays start from; else 64x36",
                             "rays from each; else 16", SettingsOptions::Moments::one);
    command->add_option("--csv", options->csv, "write the counts as CSV too")->type_name("FILE");
    command->add_option("--json", options->json, "write the counts as JSON too")->type_name("FILE");
    command
        ->add_option("--picture", options->picture,
                     "where the errors lie, for each camera: leaks red, false shadows blue")
        ->type_name("FILE");
    options->memory.add_to(*command);
    options->backend.add_to(*command);
    return [options] { return split(*options); };
}

} // namespace romascope
