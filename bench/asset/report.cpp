// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "asset/report.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "peers/peer.h"
#include "report/geometric_mean.h"
#include "report/table.h"
#include "report/text.h"
#include "support/machine.h"

namespace deltamesh::bench {
namespace {

constexpr int kDigits = 3;

double ratio_of(std::uint64_t a, std::uint64_t b) {
  return static_cast<double>(std::max<std::uint64_t>(a, 1)) / static_cast<double>(b);
}

std::uint64_t without_morph(const PartBytes& bytes) { return sum(bytes) - bytes[index_of(Part::kMorph)]; }

bool is_same(const DracoSetting& a, const DracoSetting& b) { return name_of(a) == name_of(b); }

std::vector<DracoSetting> settings_of(const std::vector<AssetRow>& rows) {
  std::vector<DracoSetting> settings;
  for (const AssetRow& row : rows)
    if (std::none_of(settings.begin(), settings.end(),
                     [&](const DracoSetting& known) { return is_same(known, row.setting); }))
      settings.push_back(row.setting);
  return settings;
}

/// Geometric mean and largest of one figure over the assets that have it.
struct Summary {
  GeometricMean mean;
  double largest = 0;
  int count = 0;

  void add(double value) {
    mean.add(value);
    largest = std::max(largest, value);
    ++count;
  }
  std::string text() const {
    const auto value = mean.value();
    if (!value) return "none";
    return join({"geometric mean ", fixed(*value, kDigits), ", largest ", fixed(largest, kDigits), " (",
                 std::to_string(count), count == 1 ? " asset)" : " assets)"});
  }
};

std::string bytes_table(const std::vector<AssetRow>& rows, const DracoSetting& setting) {
  std::string text = join({"### Bytes at ", name_of(setting), "\n\n"}) +
                     table_head({"asset", "vertices", "Draco", "ours", "ratio", "meshoptimizer",
                                 "morph Draco", "morph ours", "ratio with morph", "errors kept"});
  for (const AssetRow& row : rows)
    text += table_row({row.asset, number(row.vertices), number(without_morph(row.draco)),
                       number(without_morph(row.ours)), fixed(row.ratio(false), kDigits), number(row.meshopt),
                       number(row.draco[index_of(Part::kMorph)]), number(row.ours[index_of(Part::kMorph)]),
                       fixed(row.ratio(true), kDigits), row.is_kept ? "yes" : "ABOVE DRACO'S"});
  return text + '\n';
}

std::string part_table(const std::vector<AssetRow>& rows, const DracoSetting& setting) {
  Cells names{"asset"};
  names.insert(names.end(), kPartNames.begin(), kPartNames.begin() + index_of(Part::kMorph));
  std::string text =
      join({"### Parts at ", name_of(setting), ": ours / Draco = ratio\n\n"}) + table_head(names);
  for (const AssetRow& row : rows) {
    Cells cells{row.asset};
    for (std::size_t part = 0; part < index_of(Part::kMorph); ++part) {
      std::string& cell = cells.emplace_back();
      if (row.draco[part] == 0 && row.ours[part] == 0) continue;
      cell = join({number(row.ours[part]), " / ", number(row.draco[part])});
      if (row.draco[part] != 0) cell += join({" = ", fixed(ratio_of(row.ours[part], row.draco[part]), 2)});
    }
    text += table_row(cells);
  }
  return text + '\n';
}

std::string times_row(const std::string& name, const DracoSetting& setting, const AssetTimes& t) {
  const auto ms = [](double seconds) { return fixed(1000 * seconds, 2); };
  return table_row({name, name_of(setting), ms(t.decode), ms(t.draco_decode), fixed(t.decode_ratio, 2),
                    ms(t.encode), ms(t.draco_build + t.draco_encode), fixed(t.encode_ratio, 2),
                    ms(t.draco_encode), fixed(t.encode_alone_ratio, 2)});
}

std::string times_table(const std::vector<AssetRow>& rows) {
  std::string text = "### Times, milliseconds of one thread\n\n" +
                     table_head({"asset", "setting", "decode", "Draco cl 7", "ratio", "encode, effort 0",
                                 "Draco cl 7, from arrays", "ratio", "Draco cl 7, encoder alone", "ratio"},
                                2);
  for (const AssetRow& row : rows) {
    if (row.times.decode == 0) continue;
    text += times_row(row.asset, row.setting, row.times);
    if (row.draco[index_of(Part::kMorph)] != 0)
      text += times_row(row.asset + " without morph targets", row.setting, row.times_without_morph);
  }
  return text + '\n';
}

using Figure = std::function<std::optional<double>(const AssetRow&)>;

std::string summary_line(const std::vector<AssetRow>& rows, const char* name, const Figure& figure) {
  Summary all;
  for (const AssetRow& row : rows)
    if (const auto value = figure(row)) all.add(*value);
  return join({"- ", name, ": ", all.text(), "\n"});
}

std::string summaries(const std::vector<AssetRow>& rows) {
  std::string text = summary_line(rows, "whole assets, bytes over Draco's",
                                  [](const AssetRow& row) { return row.ratio(true); }) +
                     summary_line(rows, "the same without morph targets",
                                  [](const AssetRow& row) { return row.ratio(false); }) +
                     summary_line(rows, "meshoptimizer without morph targets", [](const AssetRow& row) {
                       return ratio_of(row.meshopt, without_morph(row.draco));
                     });
  for (std::size_t part = 0; part < index_of(Part::kMorph); ++part) {
    text += summary_line(rows, kPartNames[part], [part](const AssetRow& row) -> std::optional<double> {
      if (row.draco[part] == 0) return std::nullopt;
      return ratio_of(row.ours[part], row.draco[part]);
    });
  }
  text += summary_line(rows, "all attributes with seams", [](const AssetRow& row) -> std::optional<double> {
    const auto attributes = [](const PartBytes& bytes) {
      return without_morph(bytes) - bytes[index_of(Part::kGeometry)];
    };
    if (attributes(row.draco) == 0) return std::nullopt;
    return ratio_of(attributes(row.ours), attributes(row.draco));
  });
  const auto time_lines = [&](const std::string& name, double AssetTimes::*ratio) {
    const auto line = [&](const std::string& of, AssetTimes AssetRow::*times) {
      return summary_line(rows, (name + of).c_str(), [=](const AssetRow& row) -> std::optional<double> {
        if (row.*times.*ratio == 0) return std::nullopt;
        return row.*times.*ratio;
      });
    };
    return line("", &AssetRow::times) + line(", without morph targets", &AssetRow::times_without_morph);
  };
  return text + time_lines("decode time", &AssetTimes::decode_ratio) +
         time_lines("encode time at effort 0", &AssetTimes::encode_ratio) +
         time_lines("encode time at effort 0, over Draco's encoder alone", &AssetTimes::encode_alone_ratio) +
         '\n';
}

}  // namespace

std::string render_asset_markdown(const std::vector<AssetRow>& rows) {
  std::string text = join(
      {"# Whole assets beside Draco\n\nCommit ", kBuildInfo.commit, ", ", kBuildInfo.compiler, ", ",
       processor_name(), ", Draco ", draco_version(), ", zstd ", zstd_version(),
       ".\n\nStreams of all distinct meshes of an asset. Draco: level 10, one buffer for each primitive, "
       "settings (qp, qn, qt), 12 bits for tangents and weights, morph targets plain (and no sequential "
       "coding "
       "for their sake). Ours: `gltf pack` of each mesh, asked for Draco's rms error of positions and its "
       "largest error of every attribute in that mesh. Bytes of one of Draco's attributes are what its "
       "stream "
       "has more than one without it, seams included; ours has the seams of all attributes in one. "
       "meshoptimizer: the same lattices, then zstd -19. Times: of all that the streams hold; without morph "
       "targets the streams hold what Draco's do.\n\n"});
  for (const DracoSetting& setting : settings_of(rows)) {
    std::vector<AssetRow> own;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(own),
                 [&](const AssetRow& row) { return is_same(row.setting, setting); });
    text += bytes_table(own, setting) + part_table(own, setting) + join({"At ", name_of(setting), ":\n\n"}) +
            summaries(own);
  }
  return text + times_table(rows) + "## All settings\n\n" + summaries(rows);
}

std::string render_asset_csv(const std::vector<AssetRow>& rows) {
  std::string csv = csv_row({"asset", "qp", "qn", "qt", "vertices", "part", "our_bytes", "draco_bytes",
                             "meshopt_bytes", "error_ratio", "kept",

                             "decode_seconds", "draco_decode_seconds", "decode_ratio", "encode_seconds",
                             "draco_encode_seconds", "encode_ratio", "decode_ratio_without_morph",
                             "encode_ratio_without_morph"});
  for (const AssetRow& row : rows) {
    const auto line = [&](const char* part, std::uint64_t ours, std::uint64_t draco) {
      return Cells{quoted(row.asset),
                   number(row.setting.position_bits),
                   number(row.setting.normal_bits),
                   number(row.setting.uv_bits),
                   number(row.vertices),
                   part,
                   number(ours),
                   number(draco)};
    };
    for (std::size_t part = 0; part < kParts; ++part) {
      if (row.draco[part] == 0 && row.ours[part] == 0) continue;
      Cells cells = line(kPartNames[part], row.ours[part], row.draco[part]);
      cells.insert(cells.end(), {"", significant(row.error_ratio[part], 6)});
      cells.resize(19);
      csv += csv_row(cells);
    }
    Cells cells = line("total", sum(row.ours), sum(row.draco));
    cells.insert(cells.end(), {number(row.meshopt), "", row.is_kept ? "1" : "0"});
    const AssetTimes& t = row.times;
    for (const double figure :
         {t.decode, t.draco_decode, t.decode_ratio, t.encode, t.draco_build + t.draco_encode, t.encode_ratio,
          row.times_without_morph.decode_ratio, row.times_without_morph.encode_ratio})
      cells.push_back(significant(figure, 6));
    csv += csv_row(cells);
  }
  return csv;
}

}  // namespace deltamesh::bench
